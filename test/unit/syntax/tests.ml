let () =
  Scc_test_support.Suites.run
    [ Parse_test.suite;
      Error_test.suite;
      Property_test.suite;
      Reference_test.suite;
      Direction_test.suite ]
