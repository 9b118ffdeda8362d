# cmake -DNPM=<npm> -DFROM=<folder of package-lock.json> -DTO=<folder>: fills TO/charts with what the page takes from npm,
# or leaves it empty and says so.
file(REMOVE_RECURSE ${TO}/charts)
file(MAKE_DIRECTORY ${TO}/charts)
set(status "npm is not installed")
if(NPM)
  file(COPY ${FROM}/package.json ${FROM}/package-lock.json DESTINATION ${TO})
  execute_process(COMMAND ${NPM} ci --prefix ${TO} --no-audit --no-fund --loglevel=error RESULT_VARIABLE status)
endif()
if(status EQUAL 0)
  set(uplot ${TO}/node_modules/uplot)
  file(COPY ${uplot}/dist/uPlot.esm.js ${uplot}/dist/uPlot.min.css DESTINATION ${TO}/charts)
  file(COPY_FILE ${uplot}/LICENSE ${TO}/charts/uPlot.LICENSE)
  file(TOUCH ${TO}/fetched)
else()
  # Not touched: the next build tries again.
  message(WARNING "the page of farrier monitor --web has no charts: ${status}")
endif()
