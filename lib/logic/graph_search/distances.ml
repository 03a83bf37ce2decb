open Scc_data
open Scc_exact

type t = {
  depths : Int_vector.t;
  instants : Int_vector.t;  (** of the nearest path *)
  nearest : Int_vector.t;  (** the state before on the nearest path *)
  earliest : (int, int) Hashtbl.t;  (** the state before on the earliest path, when that is another *)
  times : Rationals.t;
  arrivals : Int_vector.t;  (** into [times] *)
}

type label = { depth : int; arrival : int; instant : int; before : int }

let create () =
  let vector = Int_vector.create in
  {
    depths = vector (); instants = vector (); nearest = vector ();
    earliest = Hashtbl.create 16;
    times = Rationals.create ();
    arrivals = vector ();
  }

let origin = { depth = 0; arrival = 0; instant = 0; before = -1 }

let push d l =
  Int_vector.push d.depths l.depth;
  Int_vector.push d.arrivals l.arrival;
  Int_vector.push d.instants l.instant;
  Int_vector.push d.nearest l.before

let depth d i = Int_vector.get d.depths i
let arrival_number d i = Int_vector.get d.arrivals i
let time d n = Rationals.get d.times n
let arrival d i = time d (arrival_number d i)
let instant d i = Int_vector.get d.instants i
let before_nearest d i = Int_vector.get d.nearest i

let before_earliest d i =
  match Hashtbl.find_opt d.earliest i with Some j -> j | None -> before_nearest d i

let after d i ~transitions duration =
  let depth = depth d i + transitions and before = i in
  match duration with
  | None -> { depth; arrival = arrival_number d i; instant = instant d i + transitions; before }
  | Some t -> { depth; arrival = Rationals.intern d.times (Rat.add (arrival d i) t); instant = 0; before }

let improve d i l =
  let nearer = l.depth < depth d i in
  let known = arrival_number d i in
  let is_earlier = l.arrival <> known && Rat.compare (time d l.arrival) (time d known) < 0 in
  if nearer || is_earlier then begin
    (* The two paths may be one, and then part here. *)
    let earliest = if is_earlier then l.before else before_earliest d i in
    if nearer then begin
      Int_vector.set d.depths i l.depth;
      Int_vector.set d.instants i l.instant;
      Int_vector.set d.nearest i l.before
    end;
    if is_earlier then Int_vector.set d.arrivals i l.arrival;
    if earliest = before_nearest d i then Hashtbl.remove d.earliest i
    else Hashtbl.replace d.earliest i earliest
  end;
  (nearer, is_earlier)

let greatest_depth d =
  let n = Int_vector.length d.depths in
  let rec from i best = if i = n then best else from (i + 1) (Int.max best (depth d i)) in
  from 0 0

(* Few of the numbers of times differ from one state to the next. *)
let greatest_arrival d =
  let n = Int_vector.length d.arrivals in
  let rec from i last best =
    if i = n then best
    else
      let a = arrival_number d i in
      from (i + 1) a (if a = last then best else Rat.max best (time d a))
  in
  from 0 0 Rat.zero

let bytes d =
  List.fold_left (fun n v -> n + Int_vector.bytes v) 0 [ d.depths; d.instants; d.nearest; d.arrivals ]
