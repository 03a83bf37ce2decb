open Scc_data

(* Those of a state stand side by side, each as one number of its place and its target, after their number. *)
type t = {
  first : Int_vector.t;  (** by states; -1 for none *)
  mutable edges : int array;
  mutable length : int;
}

let most = 1 lsl 18
let create () = { first = Int_vector.create (); edges = [||]; length = 0 }
let half = 31

let push t number =
  if t.length = Array.length t.edges then begin
    let edges = Array.make (Int.max 256 (2 * t.length)) 0 in
    Array.blit t.edges 0 edges 0 t.length;
    t.edges <- edges
  end;
  Array.unsafe_set t.edges t.length number;
  t.length <- t.length + 1

let put t place target = push t ((place lsl half) lor target)

let keep t i each =
  if t.length < most then begin
    let at = t.length in
    push t 0;
    each (put t);
    let count = t.length - at - 1 in
    if count = 0 then t.length <- at
    else begin
      t.edges.(at) <- count;
      while Int_vector.length t.first < i do
        Int_vector.push t.first (-1)
      done;
      if Int_vector.length t.first = i then Int_vector.push t.first at else Int_vector.set t.first i at
    end
  end

let find t i =
  match if i < Int_vector.length t.first then Int_vector.get t.first i else -1 with
  | -1 -> None
  | at ->
    let edge n =
      let number = t.edges.(at + 1 + n) in
      (number lsr half, number land ((1 lsl half) - 1))
    in
    Some (List.init t.edges.(at) edge)

let bytes t = Int_vector.bytes t.first + (8 * Array.length t.edges)
