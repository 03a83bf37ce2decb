open Scc_data
open Scc_exact
module P = Pieces

type quantifier = Every_run | Some_run

(* [x] says of positive rests up to [from] what X is; above it does not matter. *)
type solution = {
  graph : Timed_graph.t;
  quantifier : quantifier;
  from : Rat.t;
  f : Positions.t;
  phi : Positions.t;
  x : P.t array;
}

let at t s rest =
  if Algebraic.compare_rat rest Rat.zero = 0 then Positions.at t.phi s else P.at t.x.(s) rest

let quantify q test targets =
  match q with Some_run -> Array.exists test targets | Every_run -> Array.for_all test targets

(* Since when f fails, at the positive offset or after it: it holds up to there. *)
let failure f offset =
  match Flow.from ~f ~g:(P.constant false) offset with
  | Lost m -> Some m.offset
  | Reached _ | Passes -> None

let first_failure f =
  match Flow.entering ~f ~g:(P.constant false) with
  | Lost m -> Some m.offset
  | Reached _ | Passes -> None

let is_before a b = match b with None -> true | Some b -> Algebraic.compare a b <= 0
let cuts p = Array.to_list p.P.cuts
let shifted d p = List.map (Algebraic.add_rat d) (cuts p)

(* What the flow of s gives, by the rest. *)
let along_flow t s =
  let f = Positions.along t.f s and phi = Positions.along t.phi s in
  let lost = first_failure f in
  let limit = Algebraic.add_rat Rat.one (Algebraic.of_rat t.from) in
  let build extra value =
    P.build ~limit:(Some limit) (Option.to_list lost @ cuts phi @ extra) value
  in
  match Timed_graph.flow t.graph s with
  | Lasts (d, targets) when Rat.compare d t.from <= 0 ->
    let later = Array.to_list targets |> List.concat_map (fun u -> shifted d t.x.(u)) in
    let all = is_before (Algebraic.of_rat d) lost in
    build (Algebraic.of_rat d :: later) (fun r ->
        if Algebraic.compare_rat r d < 0 then is_before r lost && P.at phi r
        else all && quantify t.quantifier (fun u -> at t u (Algebraic.add_rat (Rat.neg d) r)) targets)
  | No_flow | Lasts _ | Forever -> build [] (fun r -> is_before r lost && P.at phi r)

let value t ~generous s =
  if not (Positions.at t.f s) then P.constant false
  else if not (t.graph.known s) then P.constant generous
  else
    let edges = t.graph.edges s in
    let join = match t.quantifier with Some_run -> ( || ) | Every_run -> ( && ) in
    let discrete () =
      Array.fold_left
        (fun acc u -> match acc with None -> Some t.x.(u) | Some p -> Some (P.map2 join p t.x.(u)))
        None edges
    in
    match (t.graph.flow s, discrete ()) with
    | No_flow, None -> P.constant false
    | No_flow, Some p -> p
    | (Lasts _ | Forever), None -> along_flow t s
    | (Lasts _ | Forever), Some p -> P.map2 join p (along_flow t s)

(* From "nowhere" up to the least solution, until nothing changes. *)
let solve index quantifier ~generous ~from ~f ~phi =
  let graph = Timed_graph.graph index in
  let t = { graph; quantifier; from; f; phi; x = Array.make graph.size (P.constant false) } in
  let waiting = Bits.create graph.size and queue = Queue.create () in
  let enter s =
    if not (Bits.mem waiting s) then begin
      Bits.add waiting s;
      Queue.push s queue
    end
  in
  for s = graph.size - 1 downto 0 do
    enter s
  done;
  let rec go () =
    match Queue.take_opt queue with
    | None -> ()
    | Some s ->
      Bits.remove waiting s;
      let value = value t ~generous s in
      if not (P.equal value t.x.(s)) then begin
        t.x.(s) <- value;
        Timed_graph.iter_sources index s (fun u _ -> enter u)
      end;
      go ()
  in
  go ();
  t

(* At an offset o inside the flow of s: f from there on, for the time a or to the end, and then phi, or X of
   what is left. *)
let inside t s =
  let f = Positions.along t.f s and phi = Positions.along t.phi s in
  let back = Rat.neg t.from in
  let own = cuts f @ shifted back f @ shifted back phi in
  let in_flow o =
    let there = Algebraic.add_rat t.from o in
    is_before there (failure f o) && P.at phi there
  in
  match Timed_graph.flow t.graph s with
  | No_flow | Forever -> P.build ~limit:None own in_flow
  | Lasts (d, targets) ->
    let left = Rat.sub d t.from in
    let later = Array.to_list targets |> List.concat_map (fun u -> shifted left t.x.(u)) in
    let limit = Algebraic.of_rat d in
    P.build ~limit:(Some limit) ((Algebraic.of_rat left :: own) @ later) (fun o ->
        if Algebraic.compare_rat o left < 0 then in_flow o
        else
          is_before limit (failure f o)
          && quantify t.quantifier (fun u -> at t u (Algebraic.add_rat (Rat.neg left) o)) targets)

let set t =
  Positions.make t.graph ~at:(fun s -> at t s (Algebraic.of_rat t.from)) ~along:(inside t)
