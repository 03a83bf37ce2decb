(* sweep.exe COUNT SEED: so many random models, each beside its points; prints each that differs. *)

open Scc_test_faces

let () =
  let count = int_of_string Sys.argv.(1) and seed = int_of_string Sys.argv.(2) in
  let counts = Faces.counts () and bad = ref 0 in
  for i = 0 to count - 1 do
    let random = Random.State.make [| seed; i |] in
    let case = Faces.generate random in
    match Faces.differences counts random case with
    | [] -> ()
    | found ->
      incr bad;
      Printf.printf "== model %d of seed %d\n%s%s\n%!" i seed case.text (String.concat "\n" found)
  done;
  Printf.printf
    "%d models, %d refused; %d points, %d of them on faces, %d not known, %d of branching formulas before all was \
     explored; %d models differ\n"
    counts.models counts.refused counts.points counts.faces counts.unknown counts.partial !bad;
  exit (if !bad = 0 then 0 else 1)
