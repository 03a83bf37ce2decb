let () =
  Scc_test_support.Suites.run
    [ Test_mesh.suite; Test_names.suite; Test_merge.suite; Test_weld.suite; Test_hull.suite; Test_scenes.suite;
      Test_scene_nodes.suite; Test_inlines.suite; Test_interfaces.suite; Test_types.suite; Test_turn.suite;
      Test_extrusion.suite; Test_prototypes.suite; Test_written.suite; Test_gltf.suite; Test_threemf.suite;
      Test_plain.suite ]
