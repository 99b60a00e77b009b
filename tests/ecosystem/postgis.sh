#!/bin/bash
# Reads from PostGIS and writes into it, at a server of its own on loopback
# Packages: postgresql postgis postgresql-15-postgis-3 gdal-bin
set -euo pipefail

work=$(mktemp -d)
tools=$(find /usr/lib/postgresql -maxdepth 2 -name bin | sort -V | tail -n 1)
as() { "$@"; }
if [ "$(id -u)" -eq 0 ]; then # a server does not run as root
  as() { runuser -u postgres -- "$@"; }
  chown postgres "$work"
fi
stop() {
  as "$tools/pg_ctl" -D "$work/data" -m immediate stop >/dev/null 2>&1 || true
  rm -rf "$work"
}
trap stop EXIT

cd "$work"
port=$(/usr/bin/python3 -c 'import socket; s = socket.socket(); s.bind(("127.0.0.1", 0)); print(s.getsockname()[1])')
as "$tools/initdb" -D "$work/data" -U tester -A trust -E UTF8 --locale=C >/dev/null
as "$tools/pg_ctl" -D "$work/data" -l "$work/log" -w -o "-c listen_addresses=127.0.0.1 -c fsync=off -p $port -k $work" start
export PGHOST=127.0.0.1 PGPORT=$port PGUSER=tester PGDATABASE=postgres
"$tools/psql" -q -c 'CREATE EXTENSION postgis' -c 'CREATE SCHEMA results'
/usr/bin/python3 -B "$CLONE/tests/ecosystem/postgis_tables.py" "$CLONE" "$BUILD/cli/thiessen" "$tools/psql"
echo '= stations, basins and readings from PostGIS; cells, weights and rain into it'
