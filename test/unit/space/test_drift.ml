(* Which processes are within a fence of fixed bodies: whichever leaf shows it. *)

open Scc_exact
open Scc_calculus
open Scc_state_space

let text =
  {|shape Cube = box(1,1,1)
process out = Cube mass 1 at translate (0, 50, 0) velocity (1,0,0) [nil]
fixed wall = Cube at translate (0, 0, 0)
fixed other = Cube at translate (10, 0, 0)
process inner = Cube mass 1 at translate (5, 0, 0) velocity (1,0,0) [nil]
process across = Cube mass 1 at translate (10, 1/2, 5) velocity (1,0,0) [nil]
|}

let held () =
  let loaded = Scc_test_models.Load.exactly (Scc_test_models.Load.text text) in
  let m = loaded.model and s = loaded.declared in
  let d = Option.get (Drift.make m s []) in
  let leaf name =
    let is (p : State.process) = String.equal m.leaves.(p.leaves.(0).leaf).name name in
    (List.find is (Array.to_list s.processes)).leaves.(0)
  in
  let process names =
    let leaves = List.map leaf names in
    let finish (l : State.leaf) : State.finish = { at = l.leaf; site = { part = 0; feature = Face 0 } } in
    let first = List.hd leaves in
    let bonds = List.map (fun l -> State.bond "b" (finish first) (finish l)) (List.tl leaves) in
    State.process ~leaves ~bonds ~velocity:Vec.zero ~clock:None ()
  in
  let check expected names =
    Alcotest.(check bool) (String.concat " " names) expected (Drift.is_held d (process names))
  in
  check true [ "wall" ];
  check true [ "inner" ];
  check false [ "out" ];
  check false [ "across" ];
  check true [ "out"; "wall" ];
  check true [ "out"; "inner" ];
  check false [ "out"; "across" ]

let () = Alcotest.run "drift" [ ("fences", [ Alcotest.test_case "which leaf" `Quick held ]) ]
