# Runs and counts checks; sourced by scripts/test.
#   gate NAME COMMAND   passes or fails as a whole and counts one
#   suite NAME COMMAND  counts the tests that its runner reports; none at all is a failure
#   tally               prints the sum and ends the script

passed=0
failed=0
logs=target/test-logs
mkdir -p "$logs"

# A suite that hangs must not take the others' results with it.
limit=20m

run() { # NAME COMMAND: the command's exit code, its output in the log
    local name=$1
    shift
    printf '%-14s' "$name"
    timeout "$limit" "$@" >"$logs/$name.log" 2>&1 </dev/null
}

report() { # NAME PASSED FAILED SECONDS
    passed=$((passed + $2))
    failed=$((failed + $3))
    if [ "$3" = 0 ]; then
        printf '%6d passed %10d s\n' "$2" "$4"
    else
        printf '%6d passed, %d failed %10d s\n' "$2" "$3" "$4"
        sed 's/^/    /' "$logs/$1.log"
    fi
}

gate() {
    local start=$SECONDS
    if run "$@"; then report "$1" 1 0 $((SECONDS - start)); else report "$1" 0 1 $((SECONDS - start)); fi
}

suite() {
    local start=$SECONDS status good bad
    run "$@"
    status=$?
    read -r good bad < <(count "$logs/$1.log")
    if [ $status != 0 ] && [ "$bad" = 0 ]; then
        echo "$1 ended with exit code $status and reported no failed test" >>"$logs/$1.log"
        bad=1
    elif [ $((good + bad)) = 0 ]; then
        echo "$1 ran no test" >>"$logs/$1.log"
        bad=1
    fi
    report "$1" "$good" "$bad" $((SECONDS - start))
}

# Sums the closing lines of cargo test, cargo-nextest, node's test runner and Playwright's.
count() { # LOG
    sed 's/\x1b\[[0-9;]*m//g' "$1" | awk '
        function before(word,    at) { # the number that stands before a word of this line
            return match($0, "[0-9]+ " word) ? substr($0, RSTART, RLENGTH) + 0 : 0
        }
        /^test result: / || /^ *Summary \[/ || /^  [0-9]+ (passed|failed|flaky|interrupted)( \(|$)/ {
            good += before("passed")
            bad += before("failed") + before("timed out") + before("flaky") + before("interrupted")
        }
        /^(#|ℹ) pass [0-9]+$/ { good += $3 }
        /^(#|ℹ) (fail|cancelled) [0-9]+$/ { bad += $3 }
        END { print good + 0, bad + 0 }'
}

tally() {
    echo
    echo "$passed passed, $failed failed"
    [ "$failed" = 0 ]
    exit
}
