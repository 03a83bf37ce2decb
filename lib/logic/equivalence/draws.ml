open Scc_exact

type drawn = { text : string; chance : Rat.t; shown : bool  (** the chance is to be seen *) }
type kind = Drawn of drawn | Choice | Release | Other

let kind told label =
  match Label.chance label with
  | Some (_, chance) -> (
      let told = told label in
      match Label.chance told with
      | Some (text, _) -> Drawn { text; chance; shown = true }
      | None -> Drawn { text = told; chance; shown = false })
  | None -> if Label.is_of "choose" label then Choice else if Label.is_of "weak" label then Release else Other

(* What all transitions of a state are. *)
type phase = Drawing | Choosing | Releasing | Mixed

let phase (g : Graph.t) kinds s =
  let all test = Graph.known g s && not (Graph.exists g s (fun label _ -> not (test kinds.(label)))) in
  if not (Graph.exists g s (fun _ _ -> true)) then Mixed
  else if all (function Drawn _ -> true | _ -> false) then Drawing
  else if all (function Choice -> true | _ -> false) then Choosing
  else if all (function Release -> true | _ -> false) then Releasing
  else Mixed

(* What a way has drawn, in order, and where it leads. *)
type way = { texts : string list; seen : bool  (** with its chance *); target : int }

module Ways = Map.Make (struct
    type t = way

    let compare a b =
      Int.compare a.target b.target <?> fun () ->
        Bool.compare a.seen b.seen <?> fun () -> List.compare String.compare a.texts b.texts
  end)

(* What a state is left by instead of its transitions: ways by what is drawn, transitions after what is chosen; and
   whether some are not known. *)
type left = { ways : Rat.t Ways.t; steps : (int * int) list; unknown : bool }

let add way chance ways =
  Ways.update way (fun known -> Some (Option.fold ~none:chance ~some:(Rat.add chance) known)) ways

(* A draw, and then what comes of a way. *)
let before d way =
  if String.equal d.text Graph.tau then way
  else { way with texts = List.merge String.compare [ d.text ] way.texts; seen = way.seen && d.shown }

type t = { graph : Graph.t; kinds : kind array; phases : phase array; left : left option array }

let draw t d target left =
  if not (Graph.known t.graph target) then { left with unknown = true }
  else
    match t.left.(target) with
    | Some later when t.phases.(target) = Drawing ->
      let ways = Ways.fold (fun way c -> add (before d way) (Rat.mul d.chance c)) later.ways left.ways in
      { left with ways; unknown = left.unknown || later.unknown }
    | Some _ | None -> { left with ways = add (before d { texts = []; seen = true; target }) d.chance left.ways }

let choose t label target left =
  if not (Graph.known t.graph target) then { left with unknown = true }
  else
    match (t.left.(target), t.phases.(target)) with
    | Some later, Choosing ->
      { left with steps = later.steps @ left.steps; unknown = left.unknown || later.unknown }
    | _, Releasing ->
      let steps = ref left.steps in
      Graph.iter t.graph target (fun label next -> steps := (label, next) :: !steps);
      { left with steps = !steps }
    | _, (Drawing | Choosing | Mixed) -> { left with steps = (label, target) :: left.steps }

let leave t s =
  let left = ref { ways = Ways.empty; steps = []; unknown = false } in
  Graph.iter t.graph s (fun label target ->
      match t.kinds.(label) with
      | Drawn d -> left := draw t d target !left
      | Choice -> left := choose t label target !left
      | Release | Other -> ());
  t.left.(s) <- Some !left

let joins = function Drawing | Choosing -> true | Releasing | Mixed -> false

(* Each state after all of its phase that it leads to; those that may come back to themselves never. *)
let leave_all t =
  let goes_on s target = t.phases.(s) = t.phases.(target) in
  let backwards = Graph.backwards t.graph in
  let waits = Array.make t.graph.size 0 and ready = Stack.create () in
  for s = 0 to t.graph.size - 1 do
    if joins t.phases.(s) then begin
      Graph.iter t.graph s (fun _ target -> if goes_on s target then waits.(s) <- waits.(s) + 1);
      if waits.(s) = 0 then Stack.push s ready
    end
  done;
  while not (Stack.is_empty ready) do
    let s = Stack.pop ready in
    leave t s;
    Graph.sources backwards s (fun _ source ->
        if goes_on source s then begin
          waits.(source) <- waits.(source) - 1;
          if waits.(source) = 0 then Stack.push source ready
        end)
  done

let text { texts; seen; target = _ } chance =
  match texts with
  | [] -> Graph.tau
  | texts ->
    let drawn = match texts with [ one ] -> one | _ -> Printf.sprintf "{%s}" (String.concat ", " texts) in
    if seen then Label.with_chance drawn chance else drawn

let joined ~told (g : Graph.t) =
  let told label = if String.equal label Graph.tau then label else told label in
  let kinds = Array.map (kind told) g.labels in
  let phases = Array.init g.size (phase g kinds) in
  if not (Array.exists joins phases) then Graph.map_labels g told
  else begin
    let t = { graph = g; kinds; phases; left = Array.make g.size None } in
    leave_all t;
    let b = Graph.builder () in
    let numbers = Array.map (fun label -> Graph.intern b (told label)) g.labels in
    let add source label target = Graph.add b ~source ~label:numbers.(label) ~target in
    let add_way source way chance =
      Graph.add b ~source ~label:(Graph.intern b (text way chance)) ~target:way.target
    in
    let add_all s = function
      | None -> Graph.iter g s (add s)
      | Some { ways; steps; _ } ->
        Ways.iter (add_way s) ways;
        List.iter (fun (label, target) -> add s label target) steps
    in
    Array.iteri add_all t.left;
    let is_cut s = Option.fold ~none:false ~some:(fun left -> left.unknown) t.left.(s) in
    let unknown s = (not (Graph.known g s)) || is_cut s in
    Graph.reachable (Graph.finish b ~size:g.size ~initial:g.initial ~unknown)
  end
