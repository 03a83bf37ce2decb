(* Zones and points on faces of the ranges (rule Zones): a share of sweep.exe. *)

open Scc_test_faces

let share = 400

let agree () =
  let counts = Faces.counts () in
  let of_model i =
    let random = Random.State.make [| 2811; i |] in
    let case = Faces.generate random in
    List.map (fun difference -> case.text ^ difference) (Faces.differences counts random case)
  in
  Alcotest.(check (list string)) "differences" [] (List.concat_map of_model (List.init share Fun.id));
  Printf.printf "%d models, %d points, %d on faces\n" counts.models counts.points counts.faces;
  let many = counts.models > share / 4 && counts.faces > share && counts.partial > share / 4 in
  Alcotest.(check bool) "many points" true many

let () = Alcotest.run "faces of ranges" [ ("zones and points", [ Alcotest.test_case "agree" `Quick agree ]) ]
