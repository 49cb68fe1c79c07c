class Meniscus < Formula
  desc "Virtual laboratory for oscillations: simulations as texts, measuring, fitting"
  homepage "@HOMEPAGE@"
  version "@VERSION@"
  license "MIT"

  on_macos do
    on_arm do
      url "@DOWNLOADS@/download/v@VERSION@/meniscus-aarch64-apple-darwin.tar.gz"
      sha256 "@SUM meniscus-aarch64-apple-darwin.tar.gz@"
    end
    on_intel do
      url "@DOWNLOADS@/download/v@VERSION@/meniscus-x86_64-apple-darwin.tar.gz"
      sha256 "@SUM meniscus-x86_64-apple-darwin.tar.gz@"
    end
  end

  on_linux do
    on_arm do
      url "@DOWNLOADS@/download/v@VERSION@/meniscus-aarch64-unknown-linux-musl.tar.gz"
      sha256 "@SUM meniscus-aarch64-unknown-linux-musl.tar.gz@"
    end
    on_intel do
      url "@DOWNLOADS@/download/v@VERSION@/meniscus-x86_64-unknown-linux-musl.tar.gz"
      sha256 "@SUM meniscus-x86_64-unknown-linux-musl.tar.gz@"
    end
  end

  def install
    bin.install "meniscus"
  end

  test do
    assert_match version.to_s, shell_output("#{bin}/meniscus --version")
  end
end
