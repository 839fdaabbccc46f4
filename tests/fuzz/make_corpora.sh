#!/usr/bin/env bash
# Writes the seeds under tests/fuzz/corpora/ anew: make_corpora.sh TERRATACT, the command line program.  Robot and panel
# files begin from those in resources/ (*.options), models from one the fuzz programs make themselves.
set -euo pipefail
terratact=$(realpath "$1")
cd "$(dirname "$0")/../.."
corpora=tests/fuzz/corpora
rm -rf "$corpora"
mkdir -p "$corpora"/{scene_file,csv_files,candump_log,dbc_file,can_frames}

scenes=$(mktemp)
trap 'rm -f "$scenes"' EXIT
"$terratact" simulate --terrain varied --count 6 --seed 1 --out "$scenes" >/dev/null
head -n 4 "$scenes" >"$corpora/scene_file/scenes.csv"
cut -d, -f1-13 "$corpora/scene_file/scenes.csv" | sed 's/$/\r/' >"$corpora/scene_file/without_heights.csv"
awk -F, -v OFS=, 'NR == 1 { print $0, "colour" } NR > 1 { $6 = ""; $9 = ""; print $0, "grey" }' \
  "$corpora/scene_file/scenes.csv" >"$corpora/scene_file/gaps.csv"
tr , ';' <"$corpora/scene_file/scenes.csv" | sed '2,$ s/\./,/g' >"$corpora/scene_file/semicolons.csv"
sed -e 's/[^,]*/"&"/g' -e '1a "","s","rad","rad","rad","A","A","N","N","N","N","N","N"'"$(printf ',"m"%.0s' {1..11})" \
  "$corpora/scene_file/scenes.csv" >"$corpora/scene_file/quoted_with_units.csv"

# The first byte says which reader (csv_files.cpp).
printf 'px_m,z_m\n0,0\n0.5,0\n0.5,0.12\n1.5,0.2\n' >"$corpora/csv_files/points.csv"
printf 'p0,0.05,0.1,0.1\n-0.2,0,0\n' >"$corpora/csv_files/heights.csv"
printf 'bh1,h2,h3\n0,0.1,0.2\n0.3,0.2,0.1\n' >"$corpora/csv_files/blocks.csv"
printf 'p0,0;0,05\n0,5;0,1\n' >"$corpora/csv_files/decimal_commas.csv"
printf 'psep=;\nx;z\nm;m\n0;0\n1;0' >"$corpora/csv_files/units.csv"
printf 'aplace,height_m,truth_m\nedge,0.12,0.125\nedge,0.118,\nfloor,-0.01,0\n' >"$corpora/csv_files/arm.csv"
printf 'crow,class\n1,"step, low"\n2,"a ""pallet"""\n3,stairs\r\n' >"$corpora/csv_files/classes.csv"

head -n 24 docs/can_demo.log >"$corpora/candump_log/compact.log"
cp docs/can_absolem.log "$corpora/candump_log/absolem.log"
cp docs/can_payload.dbc "$corpora/dbc_file/payload.dbc"
cat >"$corpora/candump_log/long.log" <<'LOG'
 (1436509052.249713)  vcan0  RX - -  044   [5]  2A 36 6C 2B BA   '*6l+.'
  can0  0CF00400  [00]
 (000.000100)  can1  044   [4]  remote request
  can0  20000004   [8]  00 04 00 00 00 00 00 00   ERRORFRAME
	controller-problem{rx-error-warning}
DROPCOUNT: dropped 3 CAN frames on 'can0' socket (total drops 5)
(1436509052.249713) can0 12345678##1001122334455667788990A0B R
(1436509052.249713) can0 044#R4 T
LOG

printf 'date Thu Jan 01 00:16:40 1970\nbase hex  timestamps absolute\n   0.1 1  500x Rx   d 3 DD FF 01\n   0.2 2  123  Tx   r 4\n   0.3 1  ErrorFrame\n   0.4 CANFD   1 Rx  50B  1 0 9 12 00 01 02 03 04 05 06 07 08 09 0A 0B 0 0 3000\n' \
  >"$corpora/candump_log/vector.asc"
printf ';$FILEVERSION=2.1\n;$STARTTIME=44548.6028595139\n;$COLUMNS=N,O,T,B,I,d,R,L,D\n 1 100.000 DT 1 0500 Rx - 3 DD FF 01\n 2 200.0 FD 2 18FEF1FE Tx - 9 00 01 02 03 04 05 06 07 08 09 0A 0B\n 3 300.0 RR 1 0123 Rx - 4\n' \
  >"$corpora/candump_log/peak2.trc"
printf ';$FILEVERSION=1.1\n     1)     100.0  Rx     0500  3  DD FF 01\n     2)     200.0  Tx     18FEF1FE  4  RTR\n' \
  >"$corpora/candump_log/peak1.trc"
printf 'Time Stamp,ID,Extended,Dir,Bus,LEN,D1,D2,D3\n1000000,00000500,false,Rx,0,3,DD,FF,01,\n' >"$corpora/candump_log/gvret.csv"
printf 'timestamp,arbitration_id,extended,remote,error,dlc,data\n1.0,0x500,0,0,0,3,3f8B\n' >"$corpora/candump_log/python.csv"
printf '__time,id,extended,remote,error,fd,sent,local,length,data\n1.0,1280,0,0,0,0,0,0,3,DDFF01\n' >"$corpora/candump_log/own.csv"
head -n 3 docs/can_demo.log | gzip -n9 >"$corpora/candump_log/packed.log.gz"
cat >"$corpora/dbc_file/nested.dbc" <<'DBC'
BO_ 1290 Nested: 64 DEVICE
 SG_ Page M : 0|4@1+ (1,0) [0|15] "" CONSOLE
 SG_ Sub m2M : 4|4@1+ (1,0) [0|15] "" CONSOLE
 SG_ Flat m1 : 8|16@1+ (0.1,0) [0|0] "V" CONSOLE
 SG_ Deep m0 : 496|16@1- (1,0) [0|0] "A" CONSOLE
BO_ 2364540158 EEC1: 8 DEVICE
 SG_ Real : 7|64@0- (1,0) [0|0] "" CONSOLE // a comment
SG_MUL_VAL_ 1290 Deep Sub 0-0;
SG_MUL_VAL_ 1290 Sub Page 2-2;
SIG_VALTYPE_ 2364540158 Real : 2;
BA_DEF_ BO_ "VFrameFormat" ENUM "StandardCAN","J1939PG";
BA_ "VFrameFormat" BO_ 2364540158 1;
BA_ "SystemSignalLongSymbol" SG_ 1290 Flat "FlatAndMuchLonger";
DBC

# can_frames.cpp says what the twelve bytes of a record are; checksums are made right (0x40).
for log in demo absolem; do
  sed -E 's/.* ([0-9A-F])([0-9A-F]{2})#([0-9A-F]*)$/\2 \1 \3/' "docs/can_$log.log" |
    while read -r low high data; do
      printf '40%s0%s1%x%s\n' "$low" "$high" $((${#data} / 2)) "$(printf '%-16s' "$data" | tr ' ' 0)"
    done | python3 -c 'import sys; sys.stdout.buffer.write(bytes.fromhex(sys.stdin.read()))' >"$corpora/can_frames/$log"
done
