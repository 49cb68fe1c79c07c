#!/bin/sh
# Makes the films of this folder with ffmpeg, and beside each what ffprobe says of it: a line for each packet in decode order
# (presentation time in seconds, size, offset, flags: K key, D decoded but not shown), and a line `frame,time` for each frame shown.
# The films are committed, since another version of an encoder gives other bytes.
set -e
cd "$(dirname "$0")"
make() { ffmpeg -nostdin -v error -y "$@"; }
source="testsrc=size=96x64:rate=30:duration=0.4,format=yuv420p"
h264="-c:v libx264 -preset veryfast -crf 40 -g 6 -bf 2 -x264-params b-adapt=0"
uneven="settb=1/90000,setpts=3000*N+700*mod(N\,3)+9000*gte(N\,8)"

make -f lavfi -i "$source" $h264 h264.mp4
make -f lavfi -i "$source" $h264 -movflags +faststart -metadata com.android.capture.fps=240 -metadata creation_time=2026-03-01T10:00:00Z \
  -movflags +faststart+use_metadata_tags capture-rate.mp4
make -f lavfi -i "$source" -f lavfi -i "sine=duration=0.4" $h264 -c:a aac -b:a 16k -movflags frag_keyframe+empty_moov+default_base_moof fragments.mp4
make -f lavfi -i "$source" -f lavfi -i "sine=duration=0.4" $h264 -c:a aac -b:a 16k -movflags frag_keyframe fragments-of-old.mp4
# This ffmpeg turns counter-clockwise, the names of the films clockwise.
make -i h264.mp4 -c copy -metadata:s:v rotate=270 rotated-90.mp4
make -i h264.mp4 -c copy -metadata:s:v rotate=180 rotated-180.mp4
make -i h264.mp4 -c copy -metadata:s:v rotate=90 rotated-270.mp4
make -i h264.mp4 -c copy h264.mkv
make -f lavfi -i "$source" -vf "$uneven" -fps_mode passthrough -enc_time_base 1/90000 $h264 -video_track_timescale 90000 variable.mp4
make -ss 0.133334 -i h264.mp4 -c copy trimmed.mp4
make -i h264.mp4 -c copy -output_ts_offset 0.5 late.mov
make -f lavfi -i "$source" -c:v libx265 -preset ultrafast -x265-params log-level=none:keyint=6:info=0 -crf 40 -tag:v hvc1 hevc.mp4
make -f lavfi -i "$source" -c:v libsvtav1 -preset 12 -crf 60 -g 6 av1.mp4
make -f lavfi -i "$source" -c:v libvpx-vp9 -crf 60 -b:v 0 -cpu-used 8 -g 6 vp9.webm
make -f lavfi -i "$source" -c:v libvpx -b:v 40k -g 6 vp8.webm
make -f lavfi -i "$source" -c:v libvpx-vp9 -crf 60 -b:v 0 -cpu-used 8 -g 6 -vf "$uneven" -fps_mode passthrough -f webm -live 1 -cluster_time_limit 100 - | cat > live.webm
make -f lavfi -i "$source" -f lavfi -i "sine=duration=0.4" -c:v mjpeg -q:v 20 -c:a pcm_u8 mjpeg.avi
make -f lavfi -i "$source" -c:v mjpeg -q:v 20 mjpeg.mov
for film in *.mp4 *.mov *.mkv *.webm *.avi; do
  {
    ffprobe -v error -select_streams v -show_entries packet=pts_time,size,pos,flags -of csv=p=0 "$film"
    ffprobe -v error -select_streams v -show_entries frame=pts_time -of csv "$film"
  } | sed 's/,side_data//; s/,*$//; /^$/d' > "$film.csv"
done
