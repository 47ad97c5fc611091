# shellcheck shell=bash
# SPDX-FileCopyrightText: Penumbra authors
# SPDX-License-Identifier: BSD-3-Clause

# ./run roots: the demo and the tests in bare Debian roots. Sourced by ./run, whose step(), logged() and fail() it uses.

roots_usage() {
  cat <<'TEXT'
usage: ./run roots [OPTION...] [12|13|testing]...

Creates a bare Debian of each given release with debootstrap (by default of all three), clones this
repository's last commit into it, and runs ./run demo and ./run test there as a new user: in one root
against ParaView's VTK and in another against plain VTK, because the two exclude each other. Ends with a
table of results. Needs root and debootstrap. All mounts end with the command.

options
  --vtk=KIND      paraview, vtk or both (the default)
  --folder=DIR    folder of the roots, outside any source tree, or the ignored build-roots/ (the
                  default); each takes about 4 GB and is reused
  --mirror=URL    Debian's archive; the default is the one that apt uses here
  --snapshot      the mirror is a snapshot: accept expired package lists
  --jobs=N        compile N files at a time
  --ccache        keep compiled files in DIR/ccache, for all roots and runs
  --fresh         create the roots from scratch
  --only=COMMAND  run only demo or test
  -- ARGUMENT...  the rest goes to ctest

environment
  PENUMBRA_ROOTS  the same as --folder
TEXT
}

roots_folder=${PENUMBRA_ROOTS:-build-roots}
roots_vtk="paraview vtk"
roots_commands="demo test"
roots_mirror=""
roots_snapshot=no
roots_ccache=no
roots_fresh=no
roots_releases=()
roots_ctest=()

parse_roots() {
  while [ $# -gt 0 ]; do
    case $1 in
      --vtk=both) ;;
      --vtk=paraview | --vtk=vtk) roots_vtk=${1#*=} ;;
      --vtk=*) fail "$1: must be paraview, vtk or both." ;;
      --folder=?*) roots_folder=${1#*=} ;;
      --mirror=?*) roots_mirror=${1#*=} ;;
      --snapshot) roots_snapshot=yes ;;
      --jobs=*) jobs=${1#*=} ;;
      --ccache) roots_ccache=yes ;;
      --fresh) roots_fresh=yes ;;
      --only=demo | --only=test) roots_commands=${1#*=} ;;
      --only=*) fail "$1: must be demo or test." ;;
      --help | -h) roots_usage; exit 0 ;;
      --) shift; roots_ctest=("$@"); break ;;
      12 | 13 | testing) roots_releases+=("$1") ;;
      *) fail "unknown argument $1: see ./run roots --help." ;;
    esac
    shift
  done
  [ ${#roots_releases[@]} -gt 0 ] || roots_releases=(12 13 testing)
  [ -z "$jobs" ] || [[ $jobs =~ ^[1-9][0-9]*$ ]] || fail "--jobs=$jobs: must be a number from 1."
}

# ------------------------------------------------------------------------------------------ mirror

# The archive that apt uses here: the first source with one of Debian's own suites, in either of apt's formats.
host_mirror() {
  cat /etc/apt/sources.list /etc/apt/sources.list.d/*.list 2>/dev/null | sed 's/\[[^]]*\]//' |
    awk '$1 == "deb" { print $2, $3 }' >"$1"
  awk 'function flush(  i) { for (i = 2; uri && i <= n; ++i) print uri, suites[i]; uri = ""; n = 0 }
    FNR == 1 || NF == 0 { flush() }
    $1 == "URIs:" { uri = $2 }
    $1 == "Suites:" { n = split($0, suites) }
    END { flush() }' /etc/apt/sources.list.d/*.sources 2>/dev/null >>"$1" || true
  awk '$2 ~ /^(oldstable|stable|testing|unstable|bookworm|trixie|forky|sid)$/ && $1 ~ /^https?:/ { print $1; exit }' "$1"
}

# Configuration of apt's proxies here, for use in the roots.
host_proxies() { apt-config dump 2>/dev/null | grep -E '^Acquire::https?::Proxy ' || true; }

suite_of() {
  case $1 in
    12) echo bookworm ;;
    13) echo trixie ;;
    *) echo "$1" ;;
  esac
}

# ------------------------------------------------------------------------------------------- roots

# in_root ROOT USER COMMAND: run COMMAND in the root, in the user's home. Mounts are visible to the command only, and end
# with it, as do processes that it leaves behind.
in_root() {
  # shellcheck disable=SC2016 # expanded inside
  unshare --mount --pid --fork --kill-child --propagation private -- bash -euc '
    root=$1 user=$2 cache=$4
    mount -t proc proc "$root/proc"
    mount -t sysfs -o ro sysfs "$root/sys"
    mount -t tmpfs -o mode=755 tmpfs "$root/dev"
    for name in null zero full random urandom tty; do
      : >"$root/dev/$name"
      mount --bind "/dev/$name" "$root/dev/$name"
    done
    ln -s /proc/self/fd "$root/dev/fd"
    ln -s /proc/self/fd/0 "$root/dev/stdin"
    ln -s /proc/self/fd/1 "$root/dev/stdout"
    ln -s /proc/self/fd/2 "$root/dev/stderr"
    mkdir -m 1777 "$root/dev/shm" "$root/dev/pts"
    mount -t tmpfs -o mode=1777 tmpfs "$root/dev/shm"
    mount -t devpts -o newinstance,ptmxmode=0666,mode=620 devpts "$root/dev/pts"
    ln -s pts/ptmx "$root/dev/ptmx"
    cp -L /etc/resolv.conf "$root/etc/resolv.conf" 2>/dev/null || true
    printf "127.0.0.1 localhost %s\n" "$(uname -n)" >"$root/etc/hosts"
    if [ -n "$cache" ]; then
      mkdir -p "$cache" "$root/var/cache/ccache"
      chmod 1777 "$cache"
      mount --bind "$cache" "$root/var/cache/ccache"
      cache=/var/cache/ccache
    fi
    home=/root
    [ "$user" = root ] || home="/home/$user"
    status=0
    chroot "$root" /usr/bin/env -i HOME="$home" USER="$user" LOGNAME="$user" LANG=C.UTF-8 \
      PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin ${cache:+CCACHE_DIR="$cache" CCACHE_UMASK=000} \
      setpriv --reuid "$user" --regid "$user" --init-groups bash -c "cd; $3" || status=$?
    exit "$status"' in_root "$1" "$2" "$3" "$([ "$roots_ccache" = no ] || echo "$roots_folder/ccache")" </dev/null &
  roots_child=$!
  local status=0
  wait "$roots_child" || status=$?
  roots_child=""
  return "$status"
}

roots_child=""
# Ctrl-C does not reach the first process of a namespace, so it is killed here. All its mounts end with it.
stop_roots() {
  [ -z "$roots_child" ] || kill -KILL "$roots_child" 2>/dev/null || true
}

# bare_root RELEASE ROOT: create a root like a new user's machine, with git, sudo, and a user.
bare_root() {
  local root=$2 setup
  rm -rf "$root.part"
  debootstrap --variant=minbase --include=ca-certificates,git,sudo \
    "$(suite_of "$1")" "$root.part" "$roots_mirror" || return
  host_proxies >"$root.part/etc/apt/apt.conf.d/90host"
  [ "$roots_snapshot" = no ] || echo 'Acquire::Check-Valid-Until "false";' >"$root.part/etc/apt/apt.conf.d/90snapshot"
  echo force-unsafe-io >"$root.part/etc/dpkg/dpkg.cfg.d/90roots" # faster; the root can be created again
  printf '#!/bin/sh\nexit 101\n' >"$root.part/usr/sbin/policy-rc.d" # start no services
  chmod +x "$root.part/usr/sbin/policy-rc.d"
  setup='apt-get update && useradd --create-home --shell /bin/bash user &&
    echo "user ALL=(ALL) NOPASSWD: ALL" >/etc/sudoers.d/user'
  in_root "$root.part" root "$setup" || return
  mv "$root.part" "$root"
}

copy_root() {
  rm -rf "$2.part"
  cp -a --reflink=auto "$1" "$2.part" && mv "$2.part" "$2"
}

# clone_into ROOT: clone the last commit to the user's home, without files of an earlier run.
clone_into() {
  rm -rf "$1/home/user/penumbra"
  git -c safe.directory='*' clone --quiet --no-local "$PWD" "$1/home/user/penumbra" || return
  chown -R --reference="$1/home/user" "$1/home/user/penumbra"
  [ "$roots_ccache" = no ] || [ -x "$1/usr/bin/ccache" ] ||
    in_root "$1" root "apt-get update && apt-get -y --no-install-recommends install ccache"
}

version_in() { # ROOT PACKAGE: without epoch and Debian's own suffix
  # shellcheck disable=SC2016 # dpkg-query's own
  chroot "$1" dpkg-query -W -f '${Version}' "$2" 2>/dev/null | sed -E 's/^[0-9]+://; s/[+-].*//' || true
}

# ------------------------------------------------------------------------------------------- table

roots_row() { printf '%-14s %-9s %-8s %-9s %-9s %-7s %7s %7s %8s %8s\n' "$@"; }

# Add a row to the table: the release, the versions found there, and the results.
judge_root() {
  local release=$1 kind=$2 root=$3 logs=$4 demo=$5 minutes=$6 clone=$3/home/user/penumbra
  local vtk_version paraview=- counts passed=- failed=- skipped=0
  vtk_version=$(sed -n 's/^-- Penumbra: VTK \([^ ]*\) from.*/\1/p' "$clone/build/configure.log" 2>/dev/null | tail -n 1 || true)
  [ "$kind" = vtk ] || paraview=$(version_in "$root" paraview-dev)
  counts=$(grep -E '^[0-9]+ passed, [0-9]+ failed(, [0-9]+ skipped)?$' "$logs-test.log" 2>/dev/null || true)
  if [ -n "$counts" ]; then
    read -r passed _ failed _ skipped _ <<<"$counts"
  fi
  roots_row "Debian $release" "$kind" "${vtk_version:--}" "${paraview:--}" "$(version_in "$root" libgl1-mesa-dri)" \
    "$demo" "$passed" "$failed" "${skipped:-0}" "$minutes" >>"$roots_folder/table.txt"
  # A release whose tests did not finish counts as failed.
  [ "$demo" != failed ] && [[ " $roots_commands " != *" test "* || $failed = 0 ]]
}

# try_root RELEASE KIND: run demo and tests in a copy of the release's bare root.
try_root() {
  local release=$1 kind=$2 root="$roots_folder/$1-$2" logs="$roots_folder/logs/$1-$2" demo=- started=$SECONDS arguments
  local title="Debian $1, ParaView's VTK"
  [ "$2" != vtk ] || title="Debian $1, plain VTK"
  [ -d "$root" ] || step "$title: copying the bare root" "$logs-copy.log" copy_root "$roots_folder/$release" "$root"
  step "$title: cloning" "$logs-clone.log" clone_into "$root"
  rm -f "$logs-demo.log" "$logs-test.log"
  arguments="--vtk=$kind ${jobs:+--jobs=$jobs}"
  if [[ $roots_commands = *demo* ]]; then
    say "$title: demo"
    demo=drawn
    logged "$logs-demo.log" in_root "$root" user "cd penumbra && ./run demo $arguments" || {
      demo=failed
      say "  failed: see $logs-demo.log"
    }
  fi
  if [[ $roots_commands = *test* ]]; then
    say "$title: test"
    [ ${#roots_ctest[@]} -eq 0 ] || arguments+=" -- $(printf '%q ' "${roots_ctest[@]}")"
    logged "$logs-test.log" in_root "$root" user "cd penumbra && ./run test $arguments" ||
      say "  failed: see $logs-test.log"
    tail -n 2 "$logs-test.log" | grep -E '^[0-9]+ (passed|skipped)' | sed 's/^/  /' || true
  fi
  judge_root "$release" "$kind" "$root" "$logs" "$demo" "$(((SECONDS - started + 30) / 60))"
}

run_roots() {
  parse_roots "$@"
  [ "$(id -u)" = 0 ] || fail "./run roots needs root, to create Debian systems and to enter them."
  command -v debootstrap >/dev/null || fail "debootstrap is missing: apt-get install debootstrap."
  command -v git >/dev/null || fail "git is missing: apt-get install git."
  unshare --mount --pid --fork true 2>/dev/null ||
    fail "this system does not allow mounts, like a container without privileges: use ./run roots outside it."
  mkdir -p "$roots_folder/logs"
  roots_folder=$(realpath "$roots_folder")
  [ -n "$roots_mirror" ] || roots_mirror=$(host_mirror "$roots_folder/logs/sources.txt")
  [ -n "$roots_mirror" ] || fail "apt has no Debian source here: give one with --mirror=URL."
  trap stop_roots EXIT
  trap 'stop_roots; exit 130' INT TERM
  [ -z "$(git -c safe.directory='*' status --porcelain 2>/dev/null)" ] ||
    say "There are uncommitted changes: the last commit is tested without them."
  roots_row release against VTK ParaView Mesa demo passed failed skipped minutes >"$roots_folder/table.txt"
  local release kind status=0
  for release in "${roots_releases[@]}"; do
    [ "$roots_fresh" = no ] || rm -rf "${roots_folder:?}/$release" "$roots_folder/$release"-*
    [ -d "$roots_folder/$release" ] ||
      step "Debian $release: creating a bare root" "$roots_folder/logs/$release.log" bare_root "$release" "$roots_folder/$release"
    for kind in $roots_vtk; do
      try_root "$release" "$kind" || status=1
    done
  done
  say
  cat "$roots_folder/table.txt"
  say "The logs are in $roots_folder/logs/."
  return "$status"
}
