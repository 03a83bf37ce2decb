(* Each number is added once, so that the queue is an array that never gets full. *)
type t = { order : Int_array.t; mutable taken : int; mutable used : int; added : Bits.t }

let create n = { order = Int_array.make n 0; taken = 0; used = 0; added = Bits.create n }
let mem w i = Bits.mem w.added i

let add w i =
  if not (mem w i) then begin
    Bits.add w.added i;
    Int_array.set w.order w.used i;
    w.used <- w.used + 1
  end

let rec run w visit =
  if w.taken < w.used then begin
    let i = Int_array.get w.order w.taken in
    w.taken <- w.taken + 1;
    visit i;
    run w visit
  end
