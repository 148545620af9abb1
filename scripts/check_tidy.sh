# clang-tidy over our sources with the checks of .clang-tidy; warnings are errors.
log=build/release/clang-tidy.log
# The build compiles several files as one (cmake/Options.cmake), which is what the compiler's list
# has: to clang-tidy they are headers of a file that consists of includes.
if run-clang-tidy -quiet -checks=-bugprone-suspicious-include -extra-arg=-Wno-unknown-warning-option -p build/release \
  -header-filter='/(src|courses)/.*\.(cpp|cc)$' '/(src|courses)/.*\.(cpp|cc|cxx)$' >"$log" 2>&1; then
  echo "clang-tidy: nothing to complain of"
else
  grep -E -A 4 'error:|warning:' "$log" | head -n 100
  exit 1
fi
