let () =
  Scc_test_support.Suites.run
    [ Nnls_test.suite;
      Boxes_test.suite;
      Obstacle_test.suite;
      Contact_test.suite;
      Response_test.suite;
      Data_test.suite;
      Feature_cast_test.suite ]
