#!/usr/bin/env bash
# Adds Debian packages to a signed apt repository, and makes the repository and its key if they do not exist:
#   cmake/apt_repository.sh KEYS FOLDER PACKAGE.deb...
# KEYS is a private folder for the key (mode 0700). FOLDER is served as it is, by a web server or as file:///FOLDER. The
# release of a package follows from its version: 0.2.0~deb12 goes to bookworm, 0.2.0~deb13 to trixie. Of several
# versions apt is offered the newest one that was added; FOLDER/README says how to use the repository.
set -euo pipefail
[ $# -ge 3 ] || { sed -n '2,7s/^# \{0,1\}//p' "$0" >&2; exit 2; }
keys=$(realpath -m "$1") folder=$(realpath -m "$2")
shift 2
declare -A releases=([12]=bookworm [13]=trixie)

fail() {
  echo "apt_repository.sh: $*" >&2
  exit 1
}

case $keys/ in "$folder"/*) fail "the key would be served: KEYS must not be inside $folder" ;; esac
# Prints the release that a package was built on.
release_of() {
  local version
  version=$(dpkg-deb -f "$1" Version) || fail "$1 is not a Debian package"
  [[ "$version" =~ ~deb([0-9]+)$ ]] && [ -n "${releases[${BASH_REMATCH[1]}]:-}" ] ||
    fail "the version of $1 is $version, expected one that ends in ~deb12 or ~deb13"
  echo "${releases[${BASH_REMATCH[1]}]}"
}
for package; do release_of "$package" >/dev/null; done
for tool in gpg gpgconf reprepro; do
  command -v $tool >/dev/null || fail "$tool is missing; cmake/setup.sh publish installs it"
done

export GNUPGHOME=$keys
mkdir -p -m 700 "$keys"
trap 'gpgconf --kill gpg-agent' EXIT
umask 022  # what is served, everybody reads
mkdir -p "$folder"
name="Terratact packages"
[ -n "$(gpg --batch --list-secret-keys --with-colons "$name" 2>/dev/null)" ] ||
  gpg --batch --quiet --passphrase '' --quick-generate-key "$name" rsa3072 sign never
gpg --batch --quiet --yes --export --output "$folder/terratact.gpg" "$name"

# The configuration and the database of reprepro are not served.
mkdir -p "$keys/conf"
key=$(gpg --batch --list-secret-keys --with-colons "$name" | awk -F : '$1 == "fpr" { print $10; exit }')
for release in "${releases[@]}"; do
  printf '%s\n' "Origin: Terratact" "Label: Terratact" "Codename: $release" "Architectures: amd64 arm64" \
    "Components: main" "SignWith: $key" ""
done >"$keys/conf/distributions"
repository=(reprepro --silent --confdir "$keys/conf" --dbdir "$keys/db" --outdir "$folder")
status=0
for package; do
  "${repository[@]}" --export silent-never includedeb "$(release_of "$package")" "$package" && continue
  echo "apt_repository.sh: $package was not added: another file of this version may be there; tag a new version" >&2
  status=1
done
"${repository[@]}" export

cat >"$folder/README" <<END
URL=file://$folder    # or where a web server serves this folder
wget -qO- \$URL/terratact.gpg | sudo tee /usr/share/keyrings/terratact.gpg >/dev/null    # a folder: cp instead
echo "deb [signed-by=/usr/share/keyrings/terratact.gpg] \$URL RELEASE main" | sudo tee /etc/apt/sources.list.d/terratact.list
sudo apt-get update && sudo apt-get install terratact

RELEASE is ${releases[12]} on Debian 12, ${releases[13]} on Debian 13.
END
for release in "${releases[@]}"; do "${repository[@]}" list "$release"; done
exit $status
