#!/bin/bash
# Makes the Debian package, and uses and removes it in a Debian that has nothing else
# Packages: debootstrap lintian
set -euo pipefail

work=$CLONE/build-ecosystem/package
mkdir -p "$work"
fail() {
  printf 'package.sh: %s\n' "$1"
  exit 1
}

# Of the program that the tests run.
rm -rf "$work/made"
cpack -G DEB --config "$BUILD/CPackConfig.cmake" -B "$work/made"
package=$(find "$work/made" -maxdepth 1 -name 'thiessen_*.deb')
dpkg-deb --info "$package"
lintian --allow-root --fail-on error "$package"
for file in usr/bin/thiessen usr/include/thiessen.h usr/lib/libthiessen.a usr/share/man/man1/thiessen.1.gz \
  usr/share/zsh/vendor-completions/_thiessen usr/share/doc/thiessen/copyright; do
  dpkg-deb --fsys-tarfile "$package" | tar -t "./$file" || fail "the package lacks $file"
done

[ "$(id -u)" -eq 0 ] || fail 'a Debian within this one is made by root: run this as root'

# From where this machine has its own packages.
release=$(sed -n 's/^VERSION_CODENAME=//p' /etc/os-release)
mirror=$(apt-get indextargets --format "\$(ORIGIN) \$(CODENAME) \$(COMPONENT) \$(REPO_URI)" 'Created-By: Packages' |
  sed -n "s/^Debian $release main //p" | head -n 1)
[ -n "$mirror" ] || fail "this machine's sources of packages name no Debian $release"
base=$work/debian
if [ ! -e "$base.made" ]; then
  rm -rf "$base"
  debootstrap --variant=minbase "$release" "$base" "$mirror"
  cp /etc/apt/apt.conf.d/* "$base/etc/apt/apt.conf.d/" 2>/dev/null || true
  touch "$base.made"
fi
root=$work/root
rm -rf --one-file-system "$root"
cp -a "$base" "$root"
cp /etc/resolv.conf /etc/hosts "$root/etc/" 2>/dev/null || true
cp "$package" "$root/root/thiessen.deb"
mkdir -p "$work/archives" "$root/var/cache/apt/archives"

cat >"$root/root/use.sh" <<'END'
set -eu
apt-get -q update
apt-get -q -y --no-install-recommends install /root/thiessen.deb
dpkg -L thiessen >/root/files
thiessen --version

# What the manual shows first, where samples/ is.
mkdir /root/clone
cd /root/clone
ln -s /usr/share/doc/thiessen/samples samples
zcat /usr/share/man/man1/thiessen.1.gz | sed '1,/^.SH EXAMPLES/d' | sed -n 's/\\-/-/g; s/^thiessen /&/p' | head -n 1 >example
cat example
. ./example
ls results
test "$(wc -l <results/rain.csv)" -eq 121
cd samples/textbook
thiessen rain stations.csv basin.csv rainfall.csv --metric planar | grep -x 'storm,69.836'
cd /root/clone

# The library, from the package alone and what it suggests.
apt-get -q -y --no-install-recommends install g++ libgeographiclib-dev libgeos-dev pkgconf
g++ -std=c++20 samples/library/textbook.cpp $(pkg-config --cflags --libs thiessen) -o storm
./storm | grep -x 'rainfall: 69.8364 mm'

apt-get -q -y purge thiessen
left=
while read -r file; do
  if [ -d "$file" ]; then dpkg -S "$file" >/dev/null 2>&1 || left="$left $file"
  elif [ -e "$file" ]; then left="$left $file"; fi
done </root/files
left="$left$(find / -xdev -iname '*thiessen*' ! -path '/root/*' ! -path '/proc/*' ! -path '/var/lib/apt/*' ! -path '/var/cache/*')"
test -z "$left" || { echo "left behind: $left"; exit 1; }
echo '= installed, used and removed; nothing is left'
END

# What is mounted for it is seen by it alone, and is gone when it ends.
# shellcheck disable=SC2016  # the inner shell expands
unshare --mount sh -euc '
  mount --bind "$2" "$1/var/cache/apt/archives"
  mount -t proc proc "$1/proc"
  mount --bind /dev "$1/dev"
  exec env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 DEBIAN_FRONTEND=noninteractive \
    ${http_proxy:+http_proxy="$http_proxy"} ${https_proxy:+https_proxy="$https_proxy"} ${no_proxy:+no_proxy="$no_proxy"} \
    chroot "$1" sh /root/use.sh' sh "$root" "$work/archives"
rm -rf --one-file-system "$root"
echo "= $(basename "$package"), $(($(stat -c %s "$package") / 1000)) kB, $(dpkg-deb --contents "$package" | grep -c '^-') files"
