open Scc_calculus
module Numbers = Hashtbl.Make (Behaviour)

type t = {
  number : int Numbers.t;
  terms : Behaviour.t array;
  index : (string, int) Hashtbl.t;
  names : string array;  (** of channels, sorted *)
}

(* {1 All terms} *)

let collected roots =
  let number = Numbers.create 256 in
  let rec collect found list =
    match list with
    | [] -> List.rev found
    | b :: rest when Numbers.mem number b -> collect found rest
    | b :: rest ->
      Numbers.add number b (Numbers.length number);
      collect (b :: found) (Behaviour.parts b @ rest)
  in
  let terms = collect [] roots in
  (number, terms)

let make (m : Model.t) (initial : State.t) =
  let calls = List.init (Array.length m.definitions) Behaviour.call in
  let bodies = List.map (fun (d : Behaviour.definition) -> d.body) (Array.to_list m.definitions) in
  let own = List.map (fun (_, (l : State.leaf)) -> l.behaviour.term) (State.by_leaf initial) in
  let number, terms = collected ((Behaviour.nil :: calls) @ bodies @ own) in
  let name (c : Behaviour.channel) = c.name in
  let bound = List.map (fun (b : State.bond) -> b.name) (State.bonds initial) in
  let offered = List.concat_map (fun b -> List.map name (Behaviour.channels b)) terms in
  let names = Array.of_list (List.sort_uniq String.compare (bound @ offered)) in
  let index = Hashtbl.create 16 in
  Array.iteri (fun i name -> Hashtbl.replace index name i) names;
  { number; terms = Array.of_list terms; index; names }

(* {1 Terms as bytes} *)

let delay = 0
let sum = 1
let first = 2

let rec summands (b : Behaviour.t) rest = match b with Sum (a, b) -> summands a (b :: rest) | b -> b :: rest

let rec put t buffer (b : Behaviour.t) =
  match (Numbers.find_opt t.number b, b) with
  | Some n, _ -> Packed.put_nat buffer (first + n)
  | None, Delay (d, b) ->
    Packed.put_nat buffer delay;
    Packed.put_rational buffer d;
    put t buffer b
  | None, Sum _ ->
    let list = summands b [] in
    Packed.put_nat buffer sum;
    Packed.put_nat buffer (List.length list);
    List.iter (put t buffer) list
  | None, (Nil | Open _ | Weak _ | Strong _ | Wait _ | Call _) ->
    Scc_base.Bug.fail __POS__ "a behaviour that is none of the model"

let most_deep = 1000

let read t source =
  let malformed what = raise (Packed.Malformed what) in
  let rec term depth =
    if depth > most_deep then malformed "a behaviour is too deep";
    match Packed.nat source with
    | 0 ->
      let d = Packed.rational source in
      if Scc_exact.Rat.sign d <= 0 then malformed "a delay is not positive";
      Behaviour.delay d (term (depth + 1))
    | 1 -> (
        match Packed.list source (fun _ -> term (depth + 1)) with
        | a :: rest -> List.fold_left Behaviour.sum a rest
        | [] -> malformed "a sum is empty")
    | n when n - first < Array.length t.terms -> t.terms.(n - first)
    | n -> malformed (Printf.sprintf "behaviour %d is not there" (n - first))
  in
  term 0

let put_name t buffer name =
  match Hashtbl.find_opt t.index name with
  | Some i -> Packed.put_nat buffer i
  | None -> Scc_base.Bug.fail __POS__ "a channel that is none of the model"

let read_name t source = t.names.(Packed.below (Array.length t.names) ~what:"the channel" source)
