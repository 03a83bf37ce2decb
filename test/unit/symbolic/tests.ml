let () =
  Scc_test_support.Suites.run
    [ Test_meeting_cells.suite;
      Test_touching_cells.suite;
      Test_offsets.suite;
      Test_first.suite;
      Test_zone.suite;
      Test_zone_index.suite;
      Test_cases.suite ]
