open Scc_exact
module Numbers = Scc_data.Numbering.Make (Rat)

type t = Numbers.t

let intern = Numbers.number
let get = Numbers.get
let size = Numbers.size

let create () =
  let t = Numbers.create () in
  ignore (intern t Rat.zero);
  t
