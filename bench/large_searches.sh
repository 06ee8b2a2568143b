# shellcheck shell=bash disable=SC2154
# Sourced by bench/compare: what is aimed at in large explorations. Whole processes, files and page
# included, default settings but for what is said. Each ratio is of one round; the rates of geng are
# those that bench/compare has just noted.

# cost <reeve's arguments...>: seconds of the clock, of CPU, and MB
cost() {
  python "$root/bench/process_cost.py" "$reeve" explore "$@" --out "$work/large" 2>>"$log"
}

ratio() { awk "BEGIN { print $1 / $2 }"; }
last_of() { awk -v key="$1" '$1 == key { last = $2 } END { print last }' "$samples"; }

# Designs that are ranked, as often as explore says.
ranked() { # <arguments...>
  "$reeve" explore "$@" --out "$work/large" --format json 2>>"$log" |
    sed -n 's/^  "evaluated": \([0-9]*\),*$/\1/p'
}

beside_geng() { # <key> <designs> <seconds>
  note "$1.rate" "$(ratio "$2" "$3")"
  note "$1.geng" "$(awk "BEGIN { print $2 / $3 / $(last_of geng.count) }")"
}

of_fingers() { # <fingers>
  local one one_cpu megabytes two listed_cpu _
  read -r one one_cpu megabytes < <(cost --fingers "$1" --threads 1)
  read -r two _ < <(cost --fingers "$1" --threads 2)
  note "large.$1.memory" "$megabytes"
  note "large.$1.threads" "$(ratio "$one" "$two")"
  beside_geng "large.$1" "${designs[$1]}" "$two"
  read -r _ listed_cpu _ < <(cost --fingers "$1" --threads 1 --top 100000)
  note "large.$1.listed" "$(ratio "$listed_cpu" "$one_cpu")"
}

with_blocks() {
  local two _
  read -r two _ < <(cost "${blocks[@]}" --threads 2)
  beside_geng large.blocks "${designs[blocks]}" "$two"
}

load_dependent() { # <fingers>
  local plain loaded _
  read -r _ plain _ < <(cost --fingers "$1" --threads 1)
  read -r _ loaded _ < <(cost --fingers "$1" --threads 1 --model "$work/load.toml")
  note "large.$1.load" "$(ratio "$loaded" "$plain")"
}

# Solves a second of CPU: 200 designs of five fingers, 1000 draws, six grasps, pulled and released.
draws() {
  local without with plain _
  read -r _ without _ < <(cost --fingers 5 --threads 1 --top 200)
  read -r _ with _ < <(cost --fingers 5 --threads 1 --top 200 --uncertainty --draws 1000)
  plain=$("$build/bin/reeve_bench" --benchmark_filter='^evaluate_design/fingers:5$' \
    --benchmark_format=json 2>>"$log" | sed -n 's/^ *"solves_per_second": \([0-9.e+]*\).*/\1/p')
  note large.draws "$(awk "BEGIN { print 2400000 / ($with - $without) }")"
  note large.draws_ratio "$(ratio "$(last_of large.draws)" "$plain")"
}

prepare_large_searches() {
  declare -gA designs=()
  blocks=(--fingers 5 --parts all --blocks 2)
  local fingers
  for fingers in 6 7; do designs[$fingers]=$(ranked --fingers "$fingers"); done
  designs[blocks]=$(ranked "${blocks[@]}")
  cat >"$work/load.toml" <<'EOF'
[[effect]]
cause = "load_dependent_friction"
exponent = 0.15
EOF
}

large_searches() {
  of_fingers 6
  of_fingers 7
  with_blocks
  load_dependent 5
  load_dependent 6
  draws
}

large_searches_table() {
  local fingers
  printf '\n%-58s %9s %9s %9s\n' "whole processes, files and page" median least most
  for fingers in 6 7; do
    row "large.$fingers.rate" "explore, $fingers fingers, 2 threads, designs/s"
    row "large.$fingers.geng" "  over graphs/s of geng (aim: 1)"
    row "large.$fingers.threads" "  2 threads over 1 (aim: 1.9)"
    row "large.$fingers.listed" "  CPU of --top 100000 over that of 1000 (aim: 3)"
    row "large.$fingers.memory" "  memory, MB"
  done
  row large.blocks.rate "${blocks[*]}, 2 threads, designs/s"
  row large.blocks.geng "  over graphs/s of geng (aim: 0.5)"
  for fingers in 5 6; do
    row "large.$fingers.load" "CPU of friction by load over plain, $fingers fingers (aim: 4)"
  done
  row large.draws "draws, 5 fingers, tension solves/s and core"
  row large.draws_ratio "  over those of evaluate_design (aim: 0.8)"
}
