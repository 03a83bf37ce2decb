open Scc_exact
open Scc_calculus
open Scc_semantics
open Scc_state_space
module Graph = State_graph

type bits = { quarter : int; half : int; three_quarters : int; at_end : int }

type cause =
  | Steps of { bits : bits }
  | Numbers of { leaf : int; quantity : Length.quantity; bits : bits }
  | Leaves of { leaves : int list; from : Rat.t; until : Rat.t }
  | Drifts of { by : Vec.t }
  | Times
  | Orders of { states : int; instants : int }
  | Splits of { states : int; instants : int }
  | Drawing of { states : int; instants : int }
  | Grid of { states : int; of_ : int; step : Rat.t }

(** {2 What is looked at} *)

(* States of a path, as many as these at its end, and as many as these spread over all of it. *)
let window = 48
let spread = 32

(* A path shorter than this tells nothing. *)
let fewest = 12

let state context graph i = Catalogue.decode (Network_lts.catalogue context) (Graph.tuple graph i)

let last count path =
  let n = Array.length path in
  Array.sub path (Int.max 0 (n - count)) (Int.min count n)

(** {2 Numbers that grow} *)

let denominator (r : Rat.t) = Z.numbits r.den
let of_vec f (v : Vec.t) = Int.max (f v.x) (Int.max (f v.y) (f v.z))

(* Of a place only the denominators count: what flies away has long numerators too, in time. *)
let of_place (p : State.process) =
  Array.fold_left (fun most (l : State.leaf) -> Int.max most (of_vec denominator l.position)) 0 p.leaves

let quantities : Length.quantity list = [ Velocity; Spin; Orientation; Angular_momentum; Position ]

let length (quantity : Length.quantity) (p : State.process) =
  match quantity with
  | Position -> of_place p
  | Velocity | Spin | Orientation | Angular_momentum | Clock -> List.assoc quantity (Length.of_process p)

(* How a length has grown along a run, if it has in each quarter of it, or doubled in the last one: what grows in
   the beginning alone, until the first collisions have mixed all numbers, comes to an end. *)
let growing measure points =
  let n = Array.length points in
  let greatest from until =
    let most = ref 0 in
    for i = from to until - 1 do
      most := Int.max !most (measure points.(i))
    done;
    !most
  in
  let quarter = greatest 0 (n / 4) and half = greatest (n / 4) (n / 2) in
  let three_quarters = greatest (n / 2) (3 * n / 4) and at_end = greatest (3 * n / 4) n in
  let rises = quarter < half && half < three_quarters in
  let steadily = rises && three_quarters + 2 <= at_end && half * 5 / 4 <= at_end in
  let wildly = quarter <= half && half <= three_quarters && 2 * three_quarters <= at_end && at_end >= 64 in
  if steadily || wildly then Some { quarter; half; three_quarters; at_end }
  else None

(* The place of the process that each leaf is in. *)
let places (s : State.t) =
  let found = Hashtbl.create (Array.length s.processes) in
  let note i (p : State.process) = Array.iter (fun (l : State.leaf) -> Hashtbl.replace found l.leaf i) p.leaves in
  Array.iteri note s.processes;
  found

let numbers states =
  let with_places = Array.map (fun s -> (s, places s)) states in
  let model_leaf (p : State.process) = p.leaves.(0).leaf in
  let n = Array.length states in
  let of_leaf (leaf : int) quantity ((s : State.t), places) =
    Option.fold ~none:0 ~some:(fun i -> length quantity s.processes.(i)) (Hashtbl.find_opt places leaf)
  in
  let candidate p quantity =
    let leaf = model_leaf p in
    Option.map
      (fun bits -> Numbers { leaf; quantity; bits })
      (growing (of_leaf leaf quantity) with_places)
  in
  let longer best next =
    match (best, next) with
    | Some (Numbers a), Some (Numbers b) when b.bits.at_end > a.bits.at_end -> next
    | None, _ -> next
    | Some _, _ -> best
  in
  if n < fewest then None
  else
    Array.to_list states.(n - 1).State.processes
    |> List.concat_map (fun p -> List.map (candidate p) quantities)
    |> List.fold_left longer None

let steps (m : Model.t) arrivals =
  if m.steered && (not (Model.keeps_beat m)) && Array.length arrivals >= fewest then
    Option.map (fun bits -> Steps { bits }) (growing denominator arrivals)
  else None

(** {2 What comes back} *)

let without_time (s : State.t) = State.at ~step:s.step ~time:None s

let without leaf (s : State.t) =
  let others = List.filter (fun p -> not (State.has_leaf p leaf)) (Array.to_list s.processes) in
  State.make ~processes:others ~step:s.step ~time:None

(* Where the first of its leaves is: what a state is moved by, when it is another one elsewhere. *)
let place (s : State.t) = s.processes.(0).leaves.(0).position

let moved by (s : State.t) =
  let move = State.map_leaves (fun l -> { l with position = Vec.sub l.position by }) in
  State.mapi (fun _ -> move) s

let at_origin (s : State.t) = if Array.length s.processes = 0 then s else moved (place s) s

(* Two states of a run that are the same, the last of them with the one before it that is nearest to it. *)
let recurs states =
  let n = Array.length states in
  let rec earlier j i =
    if i < 0 then None else if State.equal states.(i) states.(j) then Some (i, j) else earlier j (i - 1)
  in
  let rec from j =
    if j <= 0 then None
    else match earlier j (j - 1) with Some _ as found -> found | None -> from (j - 1)
  in
  from (n - 1)

(* Up to a constant, time counts no longer than up to there. *)
let times context states =
  match Catalogue.time_seen (Network_lts.catalogue context) with
  | Scc_property.Time_seen.Always when Option.is_some (recurs (Array.map without_time states)) -> Some Times
  | Always | Until _ | Never -> None

(* What is fixed stays where it is, and counts for where the others are. *)
let loose m (s : State.t) =
  let processes = List.filter (fun p -> Option.is_some (State.mass m p)) (Array.to_list s.processes) in
  State.make ~processes ~step:s.step ~time:None

(* The last state is what two before it were, each moved by the same from the one before. *)
let drifts c states =
  let m = Semantics.model c in
  let still = Array.map (loose m) states in
  let alike = Array.map at_origin still in
  let last = Array.length states - 1 in
  let backwards = List.init (last + 1) (fun k -> last - k) in
  let same = List.filter (fun i -> State.equal alike.(i) alike.(last)) backwards in
  match same with
  | k :: j :: i :: _ when Array.length still.(k).processes > 0 ->
    let by = Vec.sub (place still.(k)) (place still.(j)) in
    let before = Vec.sub (place still.(j)) (place still.(i)) in
    let fixed leaf = m.leaves.(leaf).fixed in
    let goes_on = Open_space.is_outside c states.(last) ~inside:(fun leaf -> not (fixed leaf)) ~others:fixed in
    if Vec.equal by before && (not (Vec.is_zero by)) && goes_on then Some (Drifts { by }) else None
  | _ -> None

(* The squared distance of the centre of each process from the nearest other one. Others are taken in the order of
   their x, as long as they may be nearer. *)
let nearest m (s : State.t) =
  let centres = Array.map (State.centre_of_mass m) s.processes in
  let order = Array.init (Array.length centres) Fun.id in
  Array.stable_sort (fun i j -> Rat.compare centres.(i).Vec.x centres.(j).Vec.x) order;
  let rec look by centre least k =
    if k < 0 || k >= Array.length order then least
    else
      let d = Vec.sub centres.(order.(k)) centre in
      let is_least d2 = match least with Some l -> Rat.compare l d2 <= 0 | None -> false in
      if is_least (Rat.mul d.x d.x) then least
      else
        let d2 = Vec.dot d d in
        look by centre (if is_least d2 then least else Some d2) (k + by)
  in
  let found = Array.make (Array.length centres) None in
  Array.iteri (fun k i -> found.(i) <- look 1 centres.(i) (look (-1) centres.(i) None (k - 1)) (k + 1)) order;
  found

(* The distances of a process from the nearest other, if it is never nearer than before, and farther in the end. *)
let leaving distances (leaf : int) =
  let at k =
    let nearest, places = Lazy.force distances.(k) in
    Option.bind (Hashtbl.find_opt places leaf) (fun i -> nearest.(i))
  in
  let rec rises first before k =
    if k = Array.length distances then if Rat.compare first before < 0 then Some (first, before) else None
    else
      match at k with
      | Some d when Rat.compare before d <= 0 -> rises first d (k + 1)
      | Some _ | None -> None
  in
  Option.bind (at 0) (fun first -> rises first first 1)

let leaves_all c states =
  let m = Semantics.model c and last = states.(Array.length states - 1) in
  let others leaf = Array.map (fun s -> at_origin (without leaf s)) states in
  let distances = Array.map (fun s -> lazy (nearest m s, places s)) states in
  let is_outside (p : State.process) =
    let inside leaf = State.has_leaf p leaf in
    Open_space.is_outside c last ~inside ~others:(fun leaf -> not (inside leaf))
  in
  let goes (p : State.process) =
    let leaf = p.leaves.(0).leaf in
    match leaving distances leaf with
    | Some (from, until) when is_outside p && Option.is_some (recurs (others leaf)) ->
      Some (Leaves { leaves = State.members p; from; until })
    | Some _ | None -> None
  in
  let n = Array.length states in
  if n < fewest || Array.length states.(0).State.processes < 2 then None
  else List.find_map goes (Array.to_list states.(n - 1).State.processes)

(** {2 All of it} *)

let resources : _ Scc_graph_search.Explore.reason list = [ States; Bits; Seconds; Memory; Interrupted ]

let ended graph = List.exists (fun reason -> Graph.left_for graph reason > 0) resources

(* Along the deepest run. *)
let values context graph =
  let model = Network_lts.model context and semantics = Network_lts.semantics context in
  match Slowing.deepest graph with
  | None -> []
  | Some i ->
    let path = Array.of_list (Graph.ancestors graph i) in
    let n = Array.length path in
    let points = Array.init (Int.min n spread) (fun k -> path.((k + 1) * n / Int.min n spread - 1)) in
    let over_all = Array.map (state context graph) points in
    let at_end = Array.map (state context graph) (last window path) in
    let first causes = List.find_map (fun cause -> cause ()) causes in
    first
      [
        (fun () -> steps model (Array.map (Graph.arrival graph) points));
        (fun () -> numbers over_all);
        (fun () -> times context at_end);
        (fun () -> leaves_all semantics at_end);
        (fun () -> drifts semantics at_end);
      ]
    |> Option.to_list

let choices_at_once context graph =
  match Crowding.find context graph with
  | None -> []
  | Some { what = Events; states; instants } -> [ Orders { states; instants } ]
  | Some { what = Weak_splits; states; instants } -> [ Splits { states; instants } ]
  | Some { what = Draws; states; instants } -> [ Drawing { states; instants } ]

let looks =
  let when_ended look context graph = if ended graph then look context graph else [] in
  List.map when_ended [ values; choices_at_once ]

(** {2 In words} *)

let kind = function
  | Steps _ -> "steps"
  | Numbers _ -> "numbers"
  | Leaves _ -> "leaves"
  | Drifts _ -> "drifts"
  | Times -> "times"
  | Orders _ -> "orders"
  | Splits _ -> "splits"
  | Drawing _ -> "draws"
  | Grid _ -> "grid"

let together a b =
  let is_new cause = not (List.exists (fun other -> String.equal (kind other) (kind cause)) a) in
  a @ List.filter is_new b

let leaves = function
  | Numbers { leaf; _ } -> [ leaf ]
  | Leaves { leaves; _ } -> leaves
  | Steps _ | Drifts _ | Times | Orders _ | Splits _ | Drawing _ | Grid _ -> []

let told bits =
  Printf.sprintf "%d, %d, %d and %d bits in the quarters of the deepest run" bits.quarter bits.half
    bits.three_quarters bits.at_end

let of_each quantity =
  match (quantity : Length.quantity) with
  | Position -> "the denominators of its position have"
  | Velocity | Spin | Orientation | Angular_momentum | Clock ->
    Printf.sprintf "its %s takes" (Length.name quantity)

let instants n = if n = 1 then "one instant" else Printf.sprintf "%d instants" n

let to_string (m : Model.t) cause =
  let name leaf = m.leaves.(leaf).name in
  let say fmt = Printf.sprintf fmt in
  let crowd = say "the last %d states that were found begin at %s" in
  match cause with
  | Steps { bits } ->
    say
      "collisions cut the steps of a law short, and times become ever finer fractions: their denominators have %s"
      (told bits)
  | Numbers { leaf; quantity; bits } ->
    say "the numbers of %s grow: %s %s" (name leaf) (of_each quantity) (told bits)
  | Leaves { leaves; from; until } ->
    let distance d2 = Decimal.significant ~digits:6 (Rat.root d2) in
    say
      "%s leaves all others, while these come back to where they were: at the end of the deepest run it is %s \
       from the nearest, and was %s not long before"
      (String.concat ", " (List.map name leaves))
      (distance until) (distance from)
  | Drifts { by } -> say "all that moves comes back to what it was, but elsewhere: moved by %s" (Vec.to_string by)
  | Times -> "all comes back to what it was, but at another time"
  | Orders { states; instants = n } ->
    say "many orders of events of the same instant: %s" (crowd states (instants n))
  | Splits { states; instants = n } ->
    say "weak splits, each of which can happen or be put off: %s" (crowd states (instants n))
  | Drawing { states; instants = n } ->
    say "many draws of the same instant, each of which has several outcomes: %s" (crowd states (instants n))
  | Grid { states; of_; step } ->
    say
      "bonds may be released at the multiples of %s alone: in %d of the last %d states that were looked into, \
       time passes only until the next of these instants, where nothing else comes"
      (Rat.to_string step) states of_

let bounded = "give the check a bound: `within t`"

let cure_of_numbers (m : Model.t) =
  match m with
  | { rigid = Some { round_orientation = None; _ }; _ } ->
    "`round orientation 2^-30` and `round velocity 2^-30` keep numbers short"
  | { steered = true; rigid = None; _ } ->
    "`round(e, q)` in the law of motion, or `round velocity 2^-10`, keeps numbers short"
  | { round_velocity = None; rigid = Some _; _ } -> "`round velocity 2^-30` keeps numbers short"
  | { round_velocity = None; rigid = None; _ } ->
    "`round velocity 2^-10` keeps numbers short; bodies of equal mass exchange their velocities"
  | _ -> "a coarser `round velocity`; or " ^ bounded

let cure (m : Model.t) = function
  | Steps _ -> "`timestep d steady`, whose steps no collision ends"
  | Numbers _ -> cure_of_numbers m
  | Leaves _ -> "put a `fixed` wall in its way, or one that says `absorb`; or " ^ bounded
  | Drifts _ ->
    "speak of distances instead of positions, in checks and in laws, and leave out `fixed` bodies that nobody \
     meets: where all of it is is not told apart then; or " ^ bounded
  | Times -> "compare `time` with constants, or say `within t`, and all later times are one"
  | Orders _ ->
    "let things happen at different times; ask `possibly` and `always` of named bodies, and others are left out; \
     `collisions together` where they hang together"
  | Drawing _ ->
    "fewer bodies that draw, or fewer velocities for each of them; ask `possibly` and `always` of named bodies, \
     and others are left out; `scc estimate` for probabilities and means"
  | Grid _ ->
    "`split_step any`, where bonds may be released at any instant; or values for the parameters, by -D"
  | Splits _ ->
    "ask `possibly` and `always` of named bodies, and others are left out; release after delays that differ: \
     `eps(d). rho(...)` on both sides; a coarser `split_step`"
