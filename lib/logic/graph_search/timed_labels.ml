open Scc_exact

type t = { duration : int -> Rat.t; mutable known : Bytes.t }

let create ~duration = { duration; known = Bytes.empty }

let ask t label =
  if label >= Bytes.length t.known then begin
    let known = Bytes.make (2 * (label + 1)) '?' in
    Bytes.blit t.known 0 known 0 (Bytes.length t.known);
    t.known <- known
  end;
  let yes = Rat.sign (t.duration label) > 0 in
  Bytes.set t.known label (if yes then 'y' else 'n');
  yes

let[@inline] takes_time t label =
  let known = if label < Bytes.length t.known then Bytes.unsafe_get t.known label else '?' in
  Char.equal known 'y' || ((not (Char.equal known 'n')) && ask t label)
