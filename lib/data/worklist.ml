type t = { queue : Int_queue.t; added : Bits.t }

let create n = { queue = Int_queue.create (); added = Bits.create n }
let mem w i = Bits.mem w.added i

let add w i =
  if not (mem w i) then begin
    Bits.add w.added i;
    Int_queue.push w.queue i
  end

let rec run w visit =
  match Int_queue.take w.queue with
  | None -> ()
  | Some i ->
    visit i;
    run w visit
