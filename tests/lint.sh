#!/bin/bash
# Runs clang-tidy on the sources of src/ and cli/: tests/lint.sh BUILD-FOLDER
# A file is looked at again when it, a header of ours that it reaches, its compiler's options or .clang-tidy changed.
set -euo pipefail

clone=$(cd "$(dirname "$0")/.." && pwd)
build=$1
stamps=$build/lint
mkdir -p "$stamps"
cd "$clone"

# name TAB key, a line a file: the key hashes the file, the headers of ours that it reaches, its compile
# command and .clang-tidy.
keys() {
  python3 -B - "$build/compile_commands.json" <<'END'
import hashlib, json, os, pathlib, re, sys

commands = {os.path.realpath(entry["file"]): entry["command"] for entry in json.load(open(sys.argv[1]))}
INCLUDE = re.compile(rb'^[ \t]*#[ \t]*include[ \t]*"([^"]+)"', re.MULTILINE)

def reached(path, seen):
    if path not in seen:
        seen[path] = path.read_bytes()
        for name in map(os.fsdecode, INCLUDE.findall(seen[path])):
            for folder in (path.parent, pathlib.Path("src"), pathlib.Path(".")):
                if (folder / name).is_file():
                    reached(pathlib.Path(os.path.normpath(folder / name)), seen)
                    break
    return seen

for path in sorted([*pathlib.Path("src").rglob("*.cpp"), *pathlib.Path("cli").rglob("*.cpp")]):
    digest = hashlib.sha256(pathlib.Path(".clang-tidy").read_bytes())
    digest.update(commands.get(os.path.realpath(path), "").encode())
    for name, content in sorted(reached(path, {}).items()):
        digest.update(f"{name} {len(content)} ".encode() + content)
    print(path, digest.hexdigest()[:32], sep="\t")
END
}

lint() {
  local file=${1%%$'\t'*} stamp=$stamps/${1##*$'\t'}
  [ -e "$stamp" ] && return
  set -o pipefail
  if clang-tidy --quiet -p "$build" "$file" 2>&1 | sed -E '/^[0-9]+ warnings? generated\.$/d'; then
    touch "$stamp"
  else
    return 1
  fi
}
export -f lint
export build stamps

list=$(keys)
# shellcheck disable=SC2016
printf '%s\n' "$list" | xargs -d '\n' -r -n 1 -P "$(nproc)" bash -c 'lint "$1"' lint
