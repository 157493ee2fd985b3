# The presets release, bench and aarch64 compile the files of a library by eights (REFRASTER_UNITY): what they include
# is read, and templates are filled, once for eight. A file that has, for itself, a name that another of its library has
# for itself too cannot be among these. Other presets compile every file alone, and find an #include that is missing,
# and what compilers warn of in a file itself but not in one that it includes, such as a function without a caller.

# With each other, by eights, but not with the rest of their library.
set(compiled_apart
  raster/explain/why_unseen.cpp raster/shade/shadow/tile_shadows.cpp raster/vertex/outside.cpp
  raster/visibility/bin.cpp raster/visibility/setup_projective.cpp
  io/image/exr_check.cpp io/image/exr_header.cpp io/mesh/mtl_file.cpp io/mesh/triangulate.cpp
  io/scene/file_materials.cpp io/scene/scene_markdown.cpp io/scene/scene_reader.cpp
  gl/draw/read_back.cpp gl/probe/tie_rule.cpp gl/program/glsl_types.cpp
  verify/bounds/shadow_bounds.cpp verify/device/measured_profile.cpp verify/explain/fragment_story.cpp
  verify/explain/story_text.cpp verify/explain/would_be.cpp verify/hypotheses/prepared.cpp
  verify/hypotheses/reflection.cpp verify/hypotheses/views.cpp verify/hypotheses/window_geometry.cpp
  verify/images/image_pair.cpp verify/page/page_sections.cpp verify/transformations/transformations.cpp
  verify/transformations/whole_pixel_shift.cpp
  bench/precision/measure_coordinates.cpp bench/precision/measure_vertices.cpp
  app/commands/mesh_command.cpp app/options/completions/completions_fish.cpp app/options/unknown_words.cpp
  tests/support/scenes/fault_scenes.cpp
  tests/unit/math/test_affine.cpp tests/unit/math/test_half_of.cpp
  tests/unit/shading/test_fast.cpp tests/unit/shading/test_ggx.cpp tests/unit/shading/test_texture.cpp
  tests/unit/raster/many_cores/test_many_cores.cpp tests/unit/raster/shadow/test_shadows.cpp
  tests/unit/raster/shadow/test_triangle_tree.cpp tests/unit/raster/test_clip.cpp tests/unit/raster/test_setup.cpp
  tests/unit/raster/test_texture_slots.cpp
  tests/unit/io/test_not_a_scene.cpp tests/unit/io/test_obj.cpp tests/unit/io/test_scene_materials.cpp
  tests/unit/verify/test_compare.cpp tests/unit/verify/test_explain.cpp tests/unit/verify/test_hypotheses.cpp
  tests/unit/verify/verdict/test_device_triangle.cpp tests/unit/verify/verdict/test_judge.cpp
  tests/system/cli/test_obj_files.cpp tests/system/cli/test_textures.cpp
  tests/system/layering/test_pages.cpp tests/system/layering/test_types.cpp
  tests/system/gl/test_gl_command.cpp tests/system/gl/test_gl_samples.cpp tests/system/gl/test_odd_shaders.cpp
  tests/system/gl/test_window.cpp)

# Alone: what fits nowhere, and the instances of the fragment functions, whose code and symbols are then those of every
# other build.
set(compiled_alone
  raster/render.cpp raster/shade/attribute_setup.cpp raster/shade/exact_pieces.cpp raster/shade/precisions/double.cpp
  raster/shade/precisions/exact.cpp raster/shade/precisions/fast.cpp raster/shade/precisions/float.cpp
  raster/shadow/triangle_tree.cpp raster/vertex/transform.cpp raster/visibility/draw_projective.cpp
  raster/visibility/draw_snapped.cpp raster/visibility/runs.cpp raster/visibility/tiny/draw_small.cpp
  io/image/hdr_file.cpp io/image/jpeg_file.cpp io/image/npy_file.cpp io/image/png/png_read.cpp io/image/tga_file.cpp
  io/mesh/obj/chunk.cpp io/mesh/obj/weld.cpp io/parts/image_part.cpp io/scene/scene_file.cpp io/scene/value_kinds.cpp
  gl/draw/shadow_maps.cpp gl/probe/detail.cpp gl/probe/functions.cpp gl/probe/output_levels.cpp gl/probe/planes.cpp
  gl/probe/texture_reads.cpp
  verify/compare/compare.cpp
  suite/results/journal.cpp suite/workers/supervisor.cpp
  app/options/completions/completions_zsh.cpp
  tests/support/files/float_clauses.cpp tests/support/files/tga_clauses.cpp
  tests/support/gl/seeded_map_faults.cpp
  tests/support/slow/slow_shadows.cpp tests/support/slow/slow_visibility.cpp
  tests/unit/shading/test_affine.cpp tests/unit/shading/test_microfacet.cpp
  tests/unit/raster/shadow/test_shadow_maps.cpp tests/unit/raster/test_aovs.cpp tests/unit/raster/test_depth.cpp
  tests/unit/raster/test_fragments.cpp tests/unit/raster/test_opacity.cpp tests/unit/raster/test_two_sided.cpp
  tests/unit/raster/tiny/test_tiny_triangles.cpp
  tests/unit/io/test_obj_chunks.cpp tests/unit/io/test_obj_clauses.cpp tests/unit/io/test_obj_differential.cpp
  tests/unit/io/test_obj_normals.cpp
  tests/unit/verify/test_heat_image.cpp tests/unit/verify/test_image_pair.cpp tests/unit/verify/test_packed.cpp
  tests/unit/verify/test_transformations.cpp
  tests/system/cli/test_compare_command.cpp tests/system/cli/test_files.cpp
  tests/system/scenes/test_affine.cpp tests/system/scenes/test_exact.cpp
  tests/system/gl/test_bench_gl.cpp)

# Folders from this one down, in `result`.
function(refraster_folders result folder)
  set(folders ${folder})
  get_property(below DIRECTORY ${folder} PROPERTY SUBDIRECTORIES)
  foreach(child ${below})
    refraster_folders(deeper ${child})
    list(APPEND folders ${deeper})
  endforeach()
  set(${result} ${folders} PARENT_SCOPE)
endfunction()

# Sorts the sources of a target into groups of eight.
function(refraster_unite target)
  get_target_property(folder ${target} SOURCE_DIR)
  get_target_property(sources ${target} SOURCES)
  set(first)
  set(apart)
  foreach(source ${sources})
    cmake_path(ABSOLUTE_PATH source BASE_DIRECTORY ${folder} NORMALIZE)
    cmake_path(RELATIVE_PATH source BASE_DIRECTORY ${PROJECT_SOURCE_DIR} OUTPUT_VARIABLE name)
    if(name IN_LIST compiled_alone)
      continue()
    elseif(name IN_LIST compiled_apart)
      set(kind apart)
    else()
      set(kind first)
    endif()
    list(LENGTH ${kind} count)
    math(EXPR group "${count} / 8")
    list(APPEND ${kind} ${name})
    set_source_files_properties(${source} DIRECTORY ${folder} PROPERTIES UNITY_GROUP ${kind}_${group})
  endforeach()
  set_target_properties(${target} PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endfunction()

foreach(name ${compiled_alone} ${compiled_apart})
  if(NOT EXISTS ${PROJECT_SOURCE_DIR}/${name})
    message(FATAL_ERROR "cmake/unity.cmake lists ${name}, which is no file")
  endif()
endforeach()
refraster_folders(folders ${PROJECT_SOURCE_DIR})
foreach(folder ${folders})
  get_property(targets DIRECTORY ${folder} PROPERTY BUILDSYSTEM_TARGETS)
  foreach(target ${targets})
    get_target_property(type ${target} TYPE)
    get_target_property(is_apart ${target} EXCLUDE_FROM_ALL) # several layers in one library, whose names would meet
    if(type MATCHES "LIBRARY|EXECUTABLE" AND NOT type STREQUAL INTERFACE_LIBRARY AND NOT is_apart)
      refraster_unite(${target})
    endif()
  endforeach()
endforeach()
