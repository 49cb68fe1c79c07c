#!/bin/sh
# Installs the program `meniscus` @VERSION@ for this user. Usage: sh install.sh [FOLDER]; without a folder, ~/.local/bin.
# Remove it by deleting the file. Upgrade by running the script of a later version.
set -eu
folder=${1:-$HOME/.local/bin}
case "$(uname -s) $(uname -m)" in
  "Linux x86_64") target=x86_64-unknown-linux-musl sum=@SUM meniscus-x86_64-unknown-linux-musl.tar.gz@ ;;
  "Linux aarch64") target=aarch64-unknown-linux-musl sum=@SUM meniscus-aarch64-unknown-linux-musl.tar.gz@ ;;
  "Darwin x86_64") target=x86_64-apple-darwin sum=@SUM meniscus-x86_64-apple-darwin.tar.gz@ ;;
  "Darwin arm64") target=aarch64-apple-darwin sum=@SUM meniscus-aarch64-apple-darwin.tar.gz@ ;;
  *) echo "There is no program for $(uname -s) on $(uname -m). The page works in every browser: @HOMEPAGE@" >&2; exit 1 ;;
esac
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
archive="$work/meniscus.tar.gz"
# MENISCUS_FILES: a folder with the files of the release, where nothing is to be fetched.
if [ -n "${MENISCUS_FILES:-}" ]; then
  cp "$MENISCUS_FILES/meniscus-$target.tar.gz" "$archive"
elif command -v curl >/dev/null; then
  curl --fail --location --proto '=https' --silent --show-error --output "$archive" "@DOWNLOADS@/download/v@VERSION@/meniscus-$target.tar.gz"
else
  wget --quiet --output-document "$archive" "@DOWNLOADS@/download/v@VERSION@/meniscus-$target.tar.gz"
fi
if command -v sha256sum >/dev/null; then
  found=$(sha256sum "$archive")
else
  found=$(shasum -a 256 "$archive")
fi
if [ "${found%% *}" != "$sum" ]; then
  echo "The file is damaged or is not the one of this version; nothing was installed. Run the script again." >&2
  exit 1
fi
tar -xzf "$archive" -C "$work"
mkdir -p "$folder"
# A program that is running cannot be overwritten, but replaced.
cp "$work/meniscus" "$folder/.meniscus.new"
chmod 755 "$folder/.meniscus.new"
mv "$folder/.meniscus.new" "$folder/meniscus"
echo "$folder/meniscus is installed."
case ":$PATH:" in
  *":$folder:"*) ;;
  *) echo "Your shell does not look there yet. Add this line to ~/.profile: export PATH=\"$folder:\$PATH\"" ;;
esac
