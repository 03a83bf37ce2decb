open Scc_data

(* Silent edges are the first ones of a state. *)
let silent_successors (g : Graph.t) s =
  let first = Int_array.get g.first s and stop = Int_array.get g.first (s + 1) in
  let rec upto e = if e < stop && Graph.is_tau (Int_array.get g.label e) then upto (e + 1) else e in
  Array.init (upto first - first) (fun k -> Int_array.get g.target (first + k))

let collapse (g : Graph.t) =
  let components =
    Strong_components.compute ~size:g.size ~inside:(fun _ -> true) ~successors:(silent_successors g)
  in
  let merged =
    Graph.merge g (Strong_components.number components) ~size:(Strong_components.count components)
      ~drop_silent_loops:true
  in
  (merged, Strong_components.numbers components)
