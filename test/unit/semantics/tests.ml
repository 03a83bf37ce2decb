let () =
  Scc_test_support.Suites.run
    [ Test_behaviour.suite;
      Test_split.suite;
      Test_closing.suite;
      Test_network.suite;
      Test_draw.suite;
      Test_lots.suite;
      Test_colliding.suite;
      Test_event_run.suite; Test_crowd.suite; Test_stopping.suite;
      Test_turn.suite;
      Test_round.suite;
      Test_run.suite ]
