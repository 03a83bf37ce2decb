let () =
  Scc_test_support.Suites.run
    [ Test_polyhedron.suite;
      Test_solids.suite;
      Test_mass_properties.suite;
      Test_random.suite ]
