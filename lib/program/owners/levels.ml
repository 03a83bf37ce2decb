open Scc_data

type t = { starts : int Growable.t; ranks : Int_vector.t }

let make () = { starts = Growable.create (); ranks = Int_vector.create () }
let count l = Growable.length l.starts
let start l level = if level < count l then Growable.get l.starts level else Int_vector.length l.ranks
let rank l id = Int_vector.get l.ranks id

let add l ranks =
  Growable.push l.starts (Int_vector.length l.ranks);
  Array.iter (Int_vector.push l.ranks) ranks

let by_rank l level =
  let from = start l level in
  let size = start l (level + 1) - from in
  let places = Array.init size (fun k -> from + k) in
  let compare a b = Int.compare (rank l a) (rank l b) in
  let rec is_sorted k = k >= size || (rank l places.(k - 1) < rank l places.(k) && is_sorted (k + 1)) in
  if not (is_sorted 1) then Array.stable_sort compare places;
  places

let level l id =
  let rec search low high =
    (* The last level that starts at this state or before. *)
    if low + 1 >= high then low
    else
      let middle = (low + high) / 2 in
      if start l middle <= id then search middle high else search low middle
  in
  search 0 (count l)

let find l level wanted =
  let stop = start l (level + 1) in
  let rec from id = if id >= stop then None else if rank l id = wanted then Some id else from (id + 1) in
  from (start l level)
