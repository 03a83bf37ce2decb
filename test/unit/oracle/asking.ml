(* What tests of the oracle ask it with. *)

open Scc_oracle
open Oracle_cases

type json = Yojson.Basic.t

let case name f = Alcotest.test_case name `Quick f
let text = Alcotest.string
let check_text = Alcotest.(check text)
let shown (j : json) = Yojson.Basic.to_string j
let member = Yojson.Basic.Util.member

let create ?quotas ?surroundings () =
  let session = Session.create ?quotas ?surroundings ~version:"test" () in
  List.iter (fun r -> ignore (Oracle.handle session (shown r))) Cases.setup;
  session

let line session s =
  match Oracle.handle session s with
  | Some answer -> Yojson.Basic.from_string answer
  | None -> Alcotest.failf "no answer to %s" s

let ask session name params = line session (shown (Cases.request ~id:5 name params))
let params s = Yojson.Basic.from_string s

let result session name p =
  match member "result" (ask session name (params p)) with
  | `Null -> Alcotest.failf "no result: %s" (shown (ask session name (params p)))
  | r -> r

let code answer = Yojson.Basic.Util.(to_int (member "code" (member "error" answer)))
let refused session name p = code (ask session name (params p))
