# SPDX-License-Identifier: BSD-3-Clause

# Runs the benchmark on an octahedron and checks the JSON that it prints.
set(mesh "${FOLDER}/octahedron.obj")
file(WRITE "${mesh}" "v 1 0 0\nv -1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nv 0 0 -1\n\
f 1 3 5\nf 3 2 5\nf 2 4 5\nf 4 1 5\nf 3 1 6\nf 2 3 6\nf 4 2 6\nf 1 4 6\n")

function (run_benchmark output)
  execute_process(
    COMMAND "${BENCHMARK}" ${ARGN}
    OUTPUT_VARIABLE text
    ERROR_VARIABLE error
    RESULT_VARIABLE result)
  if (result)
    message(FATAL_ERROR "geodesicBenchmark ${ARGN} failed: ${error}")
  endif ()
  message(STATUS "${text}")
  set("${output}" "${text}" PARENT_SCOPE)
endfunction ()

function (require_value json key expected)
  string(JSON value GET "${json}" "${key}")
  if (NOT value MATCHES "^${expected}$")
    message(FATAL_ERROR "${key} is ${value}, not ${expected}")
  endif ()
endfunction ()

# From a vertex, a face's side is the square root of 2 and the vertex opposite is two heights away.
run_benchmark(json --mesh "${mesh}" --source vertex:0 --threads 1 --against "${PEERS}")
require_value("${json}" faces 8)
require_value("${json}" edges 12)
require_value("${json}" max_distance "2\\.449489743")
require_value("${json}" output_cells 8)
foreach (key IN ITEMS build_s solve_s refine_s loaded_rss_bytes peak_rss_bytes windows_propagated
    threads relative_error dijkstra_s)
  require_value("${json}" "${key}" "[0-9.e+-]+")
endforeach ()

# Errors against the exact field: none of an exact run, two sides instead of two heights along edges.
run_benchmark(json --mesh "${mesh}" --against "${PEERS}" --error)
require_value("${json}" max_relative_error 0)
require_value("${json}" dijkstra_max_relative_error "0\\.154700538.*")
string(REPLACE "," ";" peers "${PEERS}")
foreach (peer IN LISTS peers)
  require_value("${json}" ${peer}_max_relative_error "[0-9.e+-]+")
  string(JSON error GET "${json}" ${peer}_max_relative_error)
  if (error GREATER 1 OR (peer STREQUAL "cgal" AND error GREATER 1e-9))
    message(FATAL_ERROR "${peer} has an error of ${error}")
  endif ()
endforeach ()

# No more can be had of threads than as many times the speed.
run_benchmark(json --mesh "${mesh}" --model 1,2,16)
foreach (key IN ITEMS serial_share model_1 model_2 model_16)
  require_value("${json}" ${key} "[0-9.e+-]+")
  string(JSON ${key} GET "${json}" ${key})
endforeach ()
if (serial_share LESS 0 OR serial_share GREATER 1 OR model_1 GREATER 1.0001 OR model_2 GREATER 2
    OR model_2 LESS model_1 OR model_16 LESS model_2)
  message(FATAL_ERROR "The model of threads cannot be: ${json}")
endif ()

# From a path around half of it, the other vertices are one side's length away.
run_benchmark(json --mesh "${mesh}" --source path:0,1 --update)
require_value("${json}" update_s "[0-9.e+-]+")
require_value("${json}" without_reach_s "[0-9.e+-]+")
require_value("${json}" update_output_cells 8)
require_value("${json}" max_distance "1\\.224744871|1\\.414213562")

# Refined: the diagonal is the square root of 12, the distance not linear.
run_benchmark(json --mesh "${mesh}" --refine 0.001 --envelope --threads 2 --update)
require_value("${json}" threads 2)
require_value("${json}" relative_error_bound 0)
string(JSON cells GET "${json}" output_cells)
require_value("${json}" update_output_cells "${cells}")
foreach (key IN ITEMS update_s refine_s interpolation_error_bound windows_per_edge)
  require_value("${json}" "${key}" "[0-9.e+-]+")
endforeach ()
string(JSON bound GET "${json}" interpolation_error_bound)
if (cells LESS 100 OR bound GREATER 0.00346411 OR bound LESS 0.0001)
  message(FATAL_ERROR "${cells} cells with a bound of ${bound}")
endif ()

# What is asked of a field: eight paths, three isolines, which are one loop each, a table of four
# rows, and arrays.
run_benchmark(json --mesh "${mesh}" --paths 8 --contour 3 --matrix 2x4 --arrays --refine 0.001)
require_value("${json}" paths_output_cells 8)
require_value("${json}" matrix_output_cells 4)
require_value("${json}" field_output_cells 8)
require_value("${json}" arrays_output_cells 8)
foreach (query IN ITEMS paths contour refined_contour matrix field arrays)
  foreach (key IN ITEMS s loaded_rss_bytes peak_rss_bytes)
    require_value("${json}" "${query}_${key}" "[0-9.e+-]+")
  endforeach ()
endforeach ()
string(JSON lines GET "${json}" contour_output_cells)
string(JSON points GET "${json}" contour_output_points)
string(JSON refined GET "${json}" refined_contour_output_points)
if (NOT lines EQUAL 3 OR NOT points LESS refined)
  message(FATAL_ERROR "${lines} isolines of ${points} points instead of ${refined}")
endif ()

# Near targets only, of which the farthest is among them.
run_benchmark(json --mesh "${mesh}" --subdivide 3 --paths 1 --matrix 3x3 --reach 0.3)
require_value("${json}" paths_output_cells 1)
require_value("${json}" matrix_output_cells 3)

# Approximate: the bound is reported and kept, with fewer windows than exactly.
run_benchmark(json --mesh "${mesh}" --subdivide 4 --noise 0.2 --envelope)
string(JSON exact GET "${json}" windows_per_edge)
require_value("${json}" output_cells 2048)
run_benchmark(json --mesh "${mesh}" --subdivide 4 --noise 0.2 --envelope --relative-error 0.01
  --error --update)
string(JSON approximate GET "${json}" windows_per_edge)
string(JSON bound GET "${json}" relative_error_bound)
if (NOT approximate LESS exact OR bound GREATER 0.01)
  message(FATAL_ERROR "${approximate} windows an edge instead of ${exact}, bound ${bound}")
endif ()
string(JSON error GET "${json}" max_relative_error)
if (error GREATER bound OR NOT error GREATER 1e-9)
  message(FATAL_ERROR "an error of ${error} with a bound of ${bound}")
endif ()

# From the boundary of the octahedron without two faces, by the filter too.
file(WRITE "${FOLDER}/open.obj" "v 1 0 0\nv -1 0 0\nv 0 1 0\nv 0 -1 0\nv 0 0 1\nv 0 0 -1\n\
f 2 4 5\nf 4 1 5\nf 3 1 6\nf 2 3 6\nf 4 2 6\nf 1 4 6\n")
run_benchmark(json --mesh "${FOLDER}/open.obj" --source boundary --update --relative-error 0.1 --error
  --against dijkstra)
require_value("${json}" update_output_cells 6)
string(JSON error ERROR_VARIABLE missing GET "${json}" dijkstra_max_relative_error)
if (NOT missing)
  message(FATAL_ERROR "Dijkstra's error from a vertex against the field from the boundary: ${error}")
endif ()

# Subdivided, moved, written in every format and read again: the same mesh.
foreach (extension IN ITEMS obj ply stl vtp)
  set(copy "${FOLDER}/copy.${extension}")
  run_benchmark(json --mesh "${mesh}" --subdivide 2 --noise 0.1 --write "${copy}" --repeat 0)
  if (json)
    message(FATAL_ERROR "a run where there should be none: ${json}")
  endif ()
  run_benchmark(json --mesh "${copy}" --repeat 2)
  string(REGEX MATCHALL "\n" lines "${json}")
  list(LENGTH lines runs)
  if (NOT runs EQUAL 2)
    message(FATAL_ERROR "${runs} lines for two runs")
  endif ()
  string(REGEX REPLACE "\n.*" "" json "${json}")
  require_value("${json}" faces 128)
  require_value("${json}" edges 192)
endforeach ()
