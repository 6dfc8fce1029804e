# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
# A Debian of its own, for scripts that source this: make_chroot, inside, check_window, fail. Exit code 2: there can be none here.
set -euo pipefail

me=${0##*/}
fail() {
  printf '%s: %s\n' "$me" "$*" >&2
  exit 1
}

# make_chroot SUITE [OPTION OF MMDEBSTRAP...]: an empty system in the folder $chroot, which goes when the script ends.
make_chroot() {
  ((EUID == 0)) || { echo "$me: only root may make a chroot" >&2; exit 2; }
  command -v mmdebstrap >/dev/null || { echo "$me: mmdebstrap is missing: apt-get install mmdebstrap" >&2; exit 2; }
  local mirror
  mirror=$(sed -nE 's/^(deb |URIs: )(\[[^]]*\] )?(http[^ ]*).*/\3/p' /etc/apt/sources.list /etc/apt/sources.list.d/* 2>/dev/null | head -1 || true)
  chroot=$(mktemp -d)
  # --lazy: a process that still runs inside holds no mount, through which rm would delete the compiler's cache.
  trap 'umount --lazy "$chroot"/{proc,ccache} 2>/dev/null || true; rm -rf --one-file-system "$chroot"' EXIT
  mmdebstrap --variant=apt --mode=root --quiet "${@:2}" "$1" "$chroot" "${mirror:-http://deb.debian.org/debian}"
  chmod 755 "$chroot"
  mount -t proc proc "$chroot/proc" 2>/dev/null || true
  mkdir -p "$chroot/work"
}

inside() { chroot "$chroot" env -i PATH=/usr/sbin:/usr/bin:/sbin:/bin HOME=/root LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive "$@"; }

# install_inside PACKAGE...: as inside sees their names
install_inside() {
  inside apt-get -q -q -y --no-install-recommends install "$@" >"$chroot/tmp/apt.log" 2>&1 || fail "$(tail -5 "$chroot/tmp/apt.log")"
}

# check_window PROGRAM PICTURE: it opens /work/filled.ply, and is stopped when it shows the surface; the picture is kept (.xwd).
check_window() {
  local status seen=no
  rm -f "$chroot"/work/{looked,status}
  # The exit code of the window itself: xvfb-run has others, such as 5 where a slow machine keeps its folder busy.
  inside sh -c "cd /work && timeout 300 xvfb-run -a -s '-screen 0 1280x800x24 -fbdir /work' sh -c \
    '$1 filled.ply & until [ -e looked ] || ! kill -0 \$!; do sleep 1; done; kill \$!; wait \$!; echo \$? >status'" &
  python3 - "$chroot/work" "$2" <<'END_OF_LOOK' && seen=yes
import pathlib, sys, time
work, picture = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
colors = 0
end = time.monotonic() + 240
screen = work / "Xvfb_screen0"
while time.monotonic() < end and not (work / "status").exists():
    time.sleep(1)
    if not screen.exists():
        continue
    data = screen.read_bytes()
    begin = int.from_bytes(data[:4], "big") + 12 * int.from_bytes(data[76:80], "big")
    colors = len({data[at:at + 4] for at in range(begin, len(data), 4)})
    picture.write_bytes(data)
    if colors > 15000:  # the page without a scan has 6000, a surface twice as many or more
        break
print(f"   its picture has {colors} colours")
sys.exit(colors <= 15000)
END_OF_LOOK
  touch "$chroot/work/looked"
  wait $! || true
  status=$(cat "$chroot/work/status" 2>/dev/null || echo none)
  [[ $status == 143 || $status == 130 ]] || fail "the window ended by itself, with exit code $status"
  [[ $seen == yes ]] || fail "the window shows no surface: $2"
}
