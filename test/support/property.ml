let seed = 42

(* Read as a positive number, if it is one. *)
let times =
  match Option.bind (Sys.getenv_opt "SCC_TIMES") int_of_string_opt with
  | Some n when n > 0 -> n
  | Some _ | None -> 1

let case ?(speed = `Quick) (QCheck2.Test.Test cell as test) =
  (* a state for each property, so that none depends on which others ran before it *)
  let run () =
    for i = 0 to times - 1 do
      QCheck2.Test.check_exn ~rand:(Random.State.make [| seed + i |]) test
    done
  in
  Alcotest.test_case (QCheck2.Test.get_name cell) speed run

let cases tests = List.map (fun test -> case test) tests
