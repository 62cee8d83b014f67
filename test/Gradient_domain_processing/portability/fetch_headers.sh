#!/usr/bin/env bash
# fetch_headers.sh SUITE FOLDER: the headers of CGAL and Eigen of another Debian, such as trixie or sid, unpacked into FOLDER.
#
# The system's own source list with the suite exchanged, in an apt state of its own: nothing of the system changes.
set -euo pipefail
suite=$1 folder=$2
[ -e "$folder/ready" ] && exit 0
mkdir -p "$folder"
folder=$(cd "$folder" && pwd)
apt=$folder/apt
mkdir -p "$apt/lists/partial" "$apt/cache/archives/partial" "$apt/download"
if [ -f /etc/apt/sources.list.d/debian.sources ]; then
  list=$apt/suite.sources
  awk -v suite="$suite" 'BEGIN { RS = ""; ORS = "\n\n" }
    !/security/ { sub(/Suites:[^\n]*/, "Suites: " suite); print }' /etc/apt/sources.list.d/debian.sources > "$list"
else
  list=$apt/suite.list
  awk -v suite="$suite" '$1 == "deb" && / bookworm / { sub(/ bookworm /, " " suite " "); print }' /etc/apt/sources.list > "$list"
fi
options=(-o Dir::Etc::SourceList="$list" -o Dir::Etc::SourceParts=/dev/null
         -o Dir::State::Lists="$apt/lists" -o Dir::Cache="$apt/cache" -o APT::Sandbox::User=)
apt-get "${options[@]}" update
(cd "$apt/download" && apt-get "${options[@]}" download libcgal-dev libeigen3-dev)
for package in "$apt"/download/*.deb; do
  dpkg -x "$package" "$folder"
done
rm -r "$apt"
touch "$folder/ready"
