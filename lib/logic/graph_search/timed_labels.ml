open Scc_exact

type t = { duration : int -> Rat.t; transitions : int -> int; mutable known : Bytes.t }

let create ~duration ~transitions = { duration; transitions; known = Bytes.empty }

(* 'y' takes time, 'n' takes none; 's' takes none, and stands for several transitions. *)
let ask t label =
  if label >= Bytes.length t.known then begin
    let known = Bytes.make (2 * (label + 1)) '?' in
    Bytes.blit t.known 0 known 0 (Bytes.length t.known);
    t.known <- known
  end;
  let kind = if Rat.sign (t.duration label) > 0 then 'y' else if t.transitions label = 1 then 'n' else 's' in
  Bytes.set t.known label kind;
  kind

let[@inline] kind t label =
  let known = if label < Bytes.length t.known then Bytes.unsafe_get t.known label else '?' in
  if Char.equal known '?' then ask t label else known

let[@inline] takes_time t label = Char.equal (kind t label) 'y'
let[@inline] transitions t label = if Char.equal (kind t label) 's' then t.transitions label else 1
