open Scc_data
open Scc_exact
open Scc_graph_search

type first = { before : int; choice : int }
type change = Nothing | Earlier | Same

type t = {
  times : Rationals.t;
  arrivals : Int_vector.t;
  turns : Int_vector.t;
  touched : (int, first option) Hashtbl.t;  (** those of this round; with a transition where they are new *)
  mutable by_turn : int array;  (** made when it is asked for *)
}

let make () =
  {
    times = Rationals.create ();
    arrivals = Int_vector.create (); turns = Int_vector.create ();
    touched = Hashtbl.create 1024;
    by_turn = [||];
  }

let number c = Rationals.intern c.times
let time c = Rationals.get c.times
let arrival c = Int_vector.get c.arrivals

let add c ~time first =
  let id = Int_vector.length c.arrivals in
  Int_vector.push c.arrivals time;
  Int_vector.push c.turns 0;
  Hashtbl.replace c.touched id (Some first)

let compare_first a b = Int.compare a.before b.before <?> fun () -> Int.compare a.choice b.choice

let again c id ~time:number transition =
  (match Hashtbl.find_opt c.touched id with
   | Some (Some first) when compare_first transition first < 0 ->
     Hashtbl.replace c.touched id (Some transition)
   | Some _ | None -> ());
  let known = arrival c id in
  if number = known then if Hashtbl.mem c.touched id then Same else Nothing
  else if Rat.compare (time c number) (time c known) < 0 then begin
    Int_vector.set c.arrivals id number;
    if not (Hashtbl.mem c.touched id) then Hashtbl.replace c.touched id None;
    Earlier
  end
  else Nothing

let touched c = Hashtbl.fold (fun id first all -> (id, first) :: all) c.touched []

(* A table that was large once would be cleared in as much time again. *)
let close c = if Hashtbl.length c.touched > 0 then Hashtbl.reset c.touched

let set_turn c = Int_vector.set c.turns
let turn c = Int_vector.get c.turns

let find c wanted =
  let size = Int_vector.length c.turns in
  if Array.length c.by_turn <> size then begin
    c.by_turn <- Array.init size Fun.id;
    Array.stable_sort (fun a b -> Int.compare (turn c a) (turn c b)) c.by_turn
  end;
  let rec search low high =
    if low >= high then None
    else
      let middle = (low + high) / 2 in
      let found = turn c c.by_turn.(middle) in
      if found = wanted then Some c.by_turn.(middle)
      else if found < wanted then search (middle + 1) high
      else search low middle
  in
  search 0 size
