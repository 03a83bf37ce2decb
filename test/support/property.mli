(** QCheck properties as Alcotest cases, with a fixed seed: a run of the tests is the same every time. With
    [SCC_TIMES=n] in the environment each is run with n seeds, the first of which is the fixed one. *)

val case : ?speed:Alcotest.speed_level -> QCheck2.Test.t -> unit Alcotest.test_case
(** The case bears the name of the property. A failure shows the shrunk counterexample. *)

val cases : QCheck2.Test.t list -> unit Alcotest.test_case list
