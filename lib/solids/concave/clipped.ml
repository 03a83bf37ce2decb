open Scc_exact

let clip height polygon =
  let n = Array.length polygon in
  let step k =
    let a = polygon.(k) and b = polygon.((k + 1) mod n) in
    let h = height a and i = height b in
    let here = if Rat.sign h >= 0 then [ a ] else [] in
    if Rat.sign h * Rat.sign i < 0 then here @ [ Vec.axpy (Rat.div h (Rat.sub h i)) (Vec.sub b a) a ] else here
  in
  Array.of_list (List.concat (List.init n step))

let has_area polygon =
  Array.length polygon > 2 && not (Vec.is_zero (Drawn.area_vector (Array.get polygon) (Array.length polygon)))

(* Not negative on the side of the edge i that the polygon is on. *)
let inward n polygon i =
  let c = polygon.(i) and d = polygon.((i + 1) mod Array.length polygon) in
  let inner = Vec.cross n (Vec.sub d c) in
  fun x -> Vec.dot inner (Vec.sub x c)

let common n one other =
  List.fold_left (fun rest i -> clip (inward n other i) rest) one (List.init (Array.length other) Fun.id)

let difference n one other =
  let k = Array.length other in
  let rec cut found rest i =
    if i = k then if has_area rest then found else [ one ]
    else if not (has_area rest) then [ one ]
    else
      let height = inward n other i in
      let outside = clip (fun x -> Rat.neg (height x)) rest in
      cut (if has_area outside then outside :: found else found) (clip height rest) (i + 1)
  in
  cut [] one 0
