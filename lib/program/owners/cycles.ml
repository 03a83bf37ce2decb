open Scc_codec
open Scc_graph_search
open Scc_successors

type graph = {
  number : int -> int;
  find : int -> int option;
  level : int -> int;
  is_expanded : int -> bool;
}

type t = {
  part : Part.t;
  mesh : Mesh.t;
  records : Records.t array;
  pending : Records.arrow Queue.t;  (** from others: transitions to states of this owner *)
}

let kind = 'C'
let make part mesh records = { part; mesh; records; pending = Queue.create () }
let heard c peer text = Records.read c.records.(peer) c.part ~sender:peer text (fun a -> Queue.push a c.pending)

(* {1 From state to state} *)

type walk = {
  graph : graph;
  inside : (int, unit) Hashtbl.t;
  todo : int Queue.t;
  arcs : Buffer.t;  (** the numbers of sources and targets, each with the choice between them *)
  near : Tuples.spread;
}

let enter w id =
  let is_new = not (Hashtbl.mem w.inside id) in
  if is_new && w.graph.is_expanded id then begin
    Hashtbl.replace w.inside id ();
    Queue.push id w.todo
  end

let arc w ~source ~choice id =
  if w.graph.is_expanded id then begin
    List.iter (Packed.put_nat w.arcs) [ source; choice; w.graph.number id ];
    enter w id
  end

(* A transition without duration. *)
let follow c w id tuple choice (changes : Tuples.changes) =
  let source = w.graph.number id in
  if Array.length changes = 0 then arc w ~source ~choice id
  else
    let target = Tuples.apply changes tuple in
    let print = Keys.fingerprint (Filter.keys (Part.filter c.part)) target in
    let home = print.(0) mod Mesh.count c.mesh in
    if home = Mesh.number c.mesh then
      match Tuples.find (Part.table c.part) ~near:w.near changes with
      | -1 -> Scc_base.Bug.fail __POS__ "a transition that is made again leads to no state"
      | target -> arc w ~source ~choice target
    else
      let time = Option.fold ~none:0 ~some:(fun clock -> Clock.arrival clock id) (Part.clock c.part) in
      Records.put c.records.(home) ~time ~instant:0 ~before:source ~choice target

let expand c w id =
  Tuples.load (Part.table c.part) w.near id;
  let tuple = Tuples.slots w.near in
  let duration = Scc_state_space.Network_lts.duration (Filter.context (Part.filter c.part)) in
  match Filter.look (Part.filter c.part) tuple with
  | Ok (Moves steps, _) ->
    let each choice (s : Lts.step) =
      if Scc_exact.Rat.sign (duration s.label) = 0 then follow c w id tuple choice s.changes
    in
    List.iteri each steps
  | Ok ((Rests | Ends _ | Stops | Fault _), _) | Error _ -> ()

let send c ~least =
  let one peer =
    if Records.size c.records.(peer) > least then Mesh.send c.mesh peer kind (Records.take c.records.(peer))
  in
  List.iter one (Mesh.others c.mesh)

let enough = 16384

let rec walk_all c w =
  while not (Queue.is_empty w.todo) do
    expand c w (Queue.pop w.todo);
    send c ~least:enough
  done;
  send c ~least:0;
  ignore (Mesh.gather c.mesh (fun _ -> ""));
  Queue.iter (fun (a : Records.arrow) -> arc w ~source:a.before ~choice:a.choice a.id) c.pending;
  Queue.clear c.pending;
  match Mesh.sums c.mesh [ Queue.length w.todo ] with [ 0 ] -> () | _ -> walk_all c w

(* {1 What the first owner makes of it} *)

let arcs_of text =
  let source = Packed.source text in
  let rec read all =
    if Packed.at_end source then all
    else
      let from = Packed.nat source in
      let choice = Packed.nat source in
      read ((from, choice, Packed.nat source) :: all)
  in
  read []

let first_cycle texts =
  let arcs = Array.of_list (List.concat_map arcs_of (Array.to_list texts)) in
  Array.sort compare arcs;
  let ends = List.concat_map (fun (a, _, b) -> [ a; b ]) (Array.to_list arcs) in
  let nodes = Array.of_list (List.sort_uniq Int.compare ends) in
  let places = Hashtbl.create (Array.length nodes) in
  Array.iteri (fun place node -> Hashtbl.replace places node place) nodes;
  let out = Array.make (Array.length nodes) [] in
  let add (from, choice, target) =
    let place = Hashtbl.find places from in
    out.(place) <- (Hashtbl.find places target, choice) :: out.(place)
  in
  Array.iter add arcs;
  let out = Array.map List.rev out in
  First_cycle.find ~size:(Array.length nodes) ~inside:(fun _ -> true) (Array.get out)
  |> Option.map (fun (place, steps) -> (nodes.(place), List.map snd steps))

(* {1 All together} *)

let written n =
  let b = Buffer.create 8 in
  Packed.put_nat b n;
  Buffer.contents b

(* Numbers that owners tell each other, of something that may not be there. *)
let told c mine =
  let text = written (match mine with Some n -> n + 1 | None -> 0) in
  let read text = match Packed.nat (Packed.source text) with 0 -> None | n -> Some (n - 1) in
  Array.map read (Mesh.gather c.mesh (fun _ -> text))

let place c g number =
  let ids = told c (g.find number) in
  let one owner = Option.map (fun id -> { Progress.level = g.level number; owner; id }) ids.(owner) in
  List.find_map one (List.init (Array.length ids) Fun.id)

let look c g =
  let w =
    {
      graph = g;
      inside = Hashtbl.create 1024; todo = Queue.create (); arcs = Buffer.create 4096;
      near = Tuples.spread (Part.table c.part);
    }
  in
  List.iter (enter w) (Part.turning c.part);
  walk_all c w;
  let mine = Buffer.contents w.arcs in
  let texts = Mesh.gather c.mesh (fun peer -> if peer = 0 then mine else "") in
  let found = if Mesh.number c.mesh = 0 then first_cycle texts else None in
  match (told c (Option.map fst found)).(0) with
  | None -> None
  | Some number ->
    Option.map (fun place -> (place, Option.fold ~none:[] ~some:snd found)) (place c g number)

let find c g =
  match Mesh.sums c.mesh [ List.length (Part.turning c.part) ] with
  | [ 0 ] -> None
  | _ -> (
      try look c g with Packed.Malformed what -> Failure.refused "an owner: %s" what)
