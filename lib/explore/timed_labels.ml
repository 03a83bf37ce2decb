open Scc_exact

type t = { mutable known : Bytes.t }

let create () = { known = Bytes.empty }

let takes_time t label ~duration =
  if label >= Bytes.length t.known then begin
    let known = Bytes.make (2 * (label + 1)) '?' in
    Bytes.blit t.known 0 known 0 (Bytes.length t.known);
    t.known <- known
  end;
  match Bytes.unsafe_get t.known label with
  | 'y' -> true
  | 'n' -> false
  | _ ->
    let yes = Rat.sign (duration label) > 0 in
    Bytes.set t.known label (if yes then 'y' else 'n');
    yes
