# clang-tidy over our sources with the checks of .clang-tidy; warnings are errors.
log=build/release/clang-tidy.log
if run-clang-tidy -quiet -extra-arg=-Wno-unknown-warning-option -p build/release '/(src|courses)/.*\.(cpp|cc)$' >"$log" 2>&1; then
  echo "clang-tidy: nothing to complain of"
else
  grep -E -A 4 'error:|warning:' "$log" | head -n 100
  exit 1
fi
