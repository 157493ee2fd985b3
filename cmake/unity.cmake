# The preset release compiles the files of a library by eights (CMAKE_UNITY_BUILD): half of the time that a whole build
# takes. These are compiled alone: each has, for itself, a name that another file of its library has for itself too; and
# the instances of the fragment functions, whose code and symbols are then those of every other build. Other presets compile
# every file alone, and find an #include that is missing.
set(compiled_alone
  raster/explain/why_unseen.cpp raster/render.cpp raster/shade/attribute_setup.cpp raster/shade/exact_pieces.cpp
  raster/shade/precisions/double.cpp raster/shade/precisions/exact.cpp raster/shade/precisions/fast.cpp
  raster/shade/precisions/float.cpp
  raster/shade/shadow/tile_shadows.cpp raster/shadow/triangle_tree.cpp raster/vertex/outside.cpp
  raster/vertex/transform.cpp raster/visibility/bin.cpp raster/visibility/draw_projective.cpp
  raster/visibility/draw_snapped.cpp raster/visibility/runs.cpp raster/visibility/setup_projective.cpp
  raster/visibility/tiny/draw_small.cpp
  io/image/exr_check.cpp io/image/exr_header.cpp io/image/hdr_file.cpp io/image/jpeg_file.cpp io/image/npy_file.cpp
  io/image/png/png_read.cpp io/image/tga_file.cpp io/mesh/mtl_file.cpp io/mesh/obj/chunk.cpp io/mesh/obj/weld.cpp
  io/mesh/triangulate.cpp io/parts/image_part.cpp io/scene/file_materials.cpp io/scene/scene_file.cpp
  io/scene/scene_markdown.cpp io/scene/scene_reader.cpp io/scene/value_kinds.cpp
  gl/draw/read_back.cpp gl/draw/shadow_maps.cpp gl/probe/detail.cpp gl/probe/functions.cpp gl/probe/output_levels.cpp
  gl/probe/planes.cpp gl/probe/texture_reads.cpp gl/probe/tie_rule.cpp gl/program/glsl_types.cpp
  verify/bounds/shadow_bounds.cpp verify/compare/compare.cpp verify/device/measured_profile.cpp
  verify/explain/fragment_story.cpp verify/explain/story_text.cpp verify/explain/would_be.cpp
  verify/hypotheses/prepared.cpp verify/hypotheses/reflection.cpp verify/hypotheses/views.cpp
  verify/hypotheses/window_geometry.cpp verify/images/image_pair.cpp verify/page/page_sections.cpp
  verify/transformations/transformations.cpp
  verify/transformations/whole_pixel_shift.cpp
  bench/precision/measure_coordinates.cpp bench/precision/measure_vertices.cpp
  suite/results/journal.cpp suite/workers/supervisor.cpp
  app/commands/mesh_command.cpp app/options/completions/completions_fish.cpp
  app/options/completions/completions_zsh.cpp app/options/unknown_words.cpp
  tests/support/files/float_clauses.cpp tests/support/files/tga_clauses.cpp tests/support/gl/seeded_map_faults.cpp
  tests/support/scenes/fault_scenes.cpp tests/support/slow/slow_shadows.cpp tests/support/slow/slow_visibility.cpp
  tests/unit/math/test_affine.cpp tests/unit/math/test_half_of.cpp
  tests/unit/shading/test_affine.cpp tests/unit/shading/test_fast.cpp tests/unit/shading/test_ggx.cpp
  tests/unit/shading/test_microfacet.cpp tests/unit/shading/test_texture.cpp
  tests/unit/raster/many_cores/test_many_cores.cpp tests/unit/raster/shadow/test_shadow_maps.cpp
  tests/unit/raster/shadow/test_shadows.cpp tests/unit/raster/shadow/test_triangle_tree.cpp
  tests/unit/raster/test_aovs.cpp tests/unit/raster/test_clip.cpp tests/unit/raster/test_depth.cpp
  tests/unit/raster/test_fragments.cpp tests/unit/raster/test_opacity.cpp tests/unit/raster/test_setup.cpp
  tests/unit/raster/test_texture_slots.cpp tests/unit/raster/test_two_sided.cpp
  tests/unit/raster/tiny/test_tiny_triangles.cpp
  tests/unit/io/test_not_a_scene.cpp tests/unit/io/test_obj.cpp tests/unit/io/test_obj_chunks.cpp
  tests/unit/io/test_obj_clauses.cpp tests/unit/io/test_obj_differential.cpp tests/unit/io/test_obj_normals.cpp
  tests/unit/io/test_scene_materials.cpp
  tests/unit/verify/test_compare.cpp tests/unit/verify/test_explain.cpp tests/unit/verify/test_heat_image.cpp
  tests/unit/verify/test_hypotheses.cpp tests/unit/verify/test_image_pair.cpp tests/unit/verify/test_packed.cpp
  tests/unit/verify/test_transformations.cpp tests/unit/verify/verdict/test_device_triangle.cpp
  tests/unit/verify/verdict/test_judge.cpp
  tests/system/cli/test_compare_command.cpp tests/system/cli/test_files.cpp tests/system/cli/test_obj_files.cpp
  tests/system/cli/test_textures.cpp
  tests/system/scenes/test_affine.cpp tests/system/scenes/test_exact.cpp
  tests/system/layering/test_pages.cpp tests/system/layering/test_types.cpp
  tests/system/gl/test_bench_gl.cpp tests/system/gl/test_gl_command.cpp tests/system/gl/test_gl_samples.cpp
  tests/system/gl/test_odd_shaders.cpp tests/system/gl/test_window.cpp)

# Folders from this one down that have targets of their own, in `result`.
function(refraster_folders result folder)
  set(folders ${folder})
  get_property(below DIRECTORY ${folder} PROPERTY SUBDIRECTORIES)
  foreach(child ${below})
    refraster_folders(deeper ${child})
    list(APPEND folders ${deeper})
  endforeach()
  set(${result} ${folders} PARENT_SCOPE)
endfunction()

refraster_folders(folders ${PROJECT_SOURCE_DIR})
foreach(file ${compiled_alone})
  if(NOT EXISTS ${PROJECT_SOURCE_DIR}/${file})
    message(FATAL_ERROR "cmake/unity.cmake lists ${file}, which is no file")
  endif()
  set_source_files_properties(${PROJECT_SOURCE_DIR}/${file} DIRECTORY ${folders}
    PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endforeach()
