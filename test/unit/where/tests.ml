let () =
  Scc_test_support.Suites.run
    [ Test_ranges.suite;
      Test_where.suite;
      Test_words.suite;
      Test_drawing.suite ]
