let () = Alcotest.run "x" []
