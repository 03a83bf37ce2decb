open Scc_exact

(* The least t for weights x, y >= 0, each with sum 1, such that sum x_i p_i = sum y_j q_j + t w. *)
let first_meeting p q w =
  let negative = List.map Vec.neg q in
  let row component = Array.of_list (List.map component (p @ negative @ [ Vec.neg w ])) in
  let weights of_p of_q = Array.of_list (List.map of_p p @ List.map of_q q @ [ Rat.zero ]) in
  let one _ = Rat.one and none _ = Rat.zero in
  let rows =
    [|
      row (fun (v : Vec.t) -> v.x); row (fun (v : Vec.t) -> v.y); row (fun (v : Vec.t) -> v.z); weights one none;
      weights none one;
    |]
  in
  let cost = Array.append (Array.make (List.length p + List.length q) Rat.zero) [| Rat.one |] in
  Linear_program.least rows [| Rat.zero; Rat.zero; Rat.zero; Rat.one; Rat.one |] ~cost
