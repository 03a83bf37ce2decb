open Scc_exact
open Scc_geometry
open Scc_calculus
open Scc_semantics
open Walks

(* Those of some walkers: their kicks, by their indices; their numbers when the step begins; and the chance. *)
type joint = { kicked : int array; begun : int array; chance : Rat.t }

(* The walkers that wait, by slots; the others have to rest. *)
let waiting w tuple =
  let rec from i walkers others =
    if i < 0 then Some (walkers, others)
    else if tuple.(i) = Catalogue.nobody then from (i - 1) walkers others
    else
      match (Catalogue.body (catalogue w) tuple.(i)).process.draw with
      | Some (Drawn _) -> None
      | Some Waits ->
        let found = walker w tuple.(i) in
        if found.able then from (i - 1) ((i, found) :: walkers) others else None
      | None ->
        let c = course w tuple.(i) in
        if c.calm && not c.walks then from (i - 1) walkers (c :: others) else None
  in
  match from (leaves w - 1) [] [] with
  | Some ((_ :: _ :: _ as walkers), others) -> Some (Array.of_list walkers, others)
  | Some (([] | [ _ ]), _) | None -> None

(* Each kick of each of the walkers, with what it is to the others. *)
type kick = { course : course; moves : Rat.t; at_once : bool  (** blocked by a process that has not drawn *) }

let kicks_of w others (_, walker) =
  let kick (number, _, chance) =
    let course = course w number in
    { course; moves = chance; at_once = List.exists (fun o -> (together w course o).Blocked.blocks) others }
  in
  Array.map kick walker.kicks

(* Rule Blocked: which of these kicks are, as bits. *)
let blocked w (kicks : kick array) =
  let n = Array.length kicks in
  let set = ref 0 in
  let add i = set := !set lor (1 lsl i) and is_in i = !set land (1 lsl i) <> 0 in
  let how i j = together w kicks.(i).course kicks.(j).course in
  for i = 0 to n - 1 do
    if kicks.(i).at_once then add i;
    for j = i + 1 to n - 1 do
      if (how i j).blocks then begin
        add i;
        add j
      end
    done
  done;
  let rec spread () =
    let before = !set in
    for i = 0 to n - 1 do
      for j = 0 to n - 1 do
        if is_in i && (not (is_in j)) && (how (Int.min i j) (Int.max i j)).sweeps then add j
      done
    done;
    if !set <> before then spread ()
  in
  if !set <> 0 then spread ();
  !set

(* Walkers that may have to do with each other in this step are in one group. *)
let groups (kicks : kick array array) =
  let n = Array.length kicks in
  let boxes = Array.map (fun ks -> Float_box.hull (Array.map (fun k -> k.course.box) ks)) kicks in
  let group = Array.init n Fun.id in
  for i = 0 to n - 1 do
    for j = i + 1 to n - 1 do
      if group.(i) <> group.(j) && Float_box.meet boxes.(i) boxes.(j) then begin
        let old = group.(j) in
        Array.iteri (fun k g -> if g = old then group.(k) <- group.(i)) group
      end
    done
  done;
  let all = List.init n Fun.id in
  let members g = List.filter (fun i -> group.(i) = g) all in
  List.filter_map (fun g -> match members g with [] -> None | some -> Some (Array.of_list some)) all

(* All joint draws of a group, those with the same courses once. *)
let of_group w (walkers : (int * walker) array) (kicks : kick array array) members =
  let n = Array.length members in
  let chosen = Array.make n 0 and found = Joint_draws.Tuple_table.create 64 and order = ref [] in
  let now () = Array.mapi (fun k i -> kicks.(i).(chosen.(k))) members in
  let finish chance =
    let now = now () in
    let blocked = blocked w now in
    let begins k i = if blocked land (1 lsl k) <> 0 then (snd walkers.(i)).stays else now.(k).course.number in
    let begun = Array.mapi begins members in
    match Joint_draws.Tuple_table.find_opt found begun with
    | Some joint ->
      Joint_draws.Tuple_table.replace found begun { joint with chance = Rat.add joint.chance chance }
    | None ->
      order := begun :: !order;
      Joint_draws.Tuple_table.add found begun { kicked = Array.copy chosen; begun; chance }
  in
  let rec choose k chance =
    if k = n then finish chance
    else
      Array.iteri
        (fun j kick ->
           chosen.(k) <- j;
           choose (k + 1) (Rat.mul chance kick.moves))
        kicks.(members.(k))
  in
  choose 0 Rat.one;
  List.rev_map (Joint_draws.Tuple_table.find found) !order

(* Those that are blocked are the bits of a number. *)
let most_walkers = 60

let count of_each list = List.fold_left (fun n x -> if n > Joint_draws.most then n else n * of_each x) 1 list

type drawn = { walkers : (int * walker) array; parts : (int array * joint list) list }

let drawn w tuple =
  match waiting w tuple with
  | None -> None
  | Some (walkers, others) ->
    let kicks = Array.map (kicks_of w others) walkers in
    let groups = groups kicks in
    let of_one group = count (fun i -> Array.length kicks.(i)) (Array.to_list group) in
    if Array.length walkers > most_walkers || List.exists (fun g -> of_one g > Joint_draws.most) groups then None
    else
      let parts = List.map (fun g -> (g, of_group w walkers kicks g)) groups in
      if count (fun (_, joint) -> List.length joint) parts > Joint_draws.most then None
      else Some { walkers; parts }

(* All joint draws of all: their changes of the tuple, and the kicks. *)
let each drawn tuple f =
  let target = Array.copy tuple and kicked = Array.make (Array.length drawn.walkers) 0 in
  let rec go chance = function
    | [] -> f target kicked chance
    | (members, joints) :: rest ->
      let put (j : joint) =
        Array.iteri
          (fun k i ->
             target.(fst drawn.walkers.(i)) <- j.begun.(k);
             kicked.(i) <- j.kicked.(k))
          members;
        go (Rat.mul chance j.chance) rest
      in
      List.iter put joints
  in
  go Rat.one drawn.parts

let begun w tuple =
  let copy = Array.copy tuple and step = { State.remaining = timestep w; phase = Steered } in
  Catalogue.put_rest (catalogue w) copy ~step:(Some step) ~time:None;
  copy

let outcomes w tuple ~representative =
  match drawn w tuple with
  | None -> None
  | Some drawn ->
    let transitions = Array.length drawn.walkers and found = ref [] in
    let add target _ chance =
      found := { Joint_draws.tuple = representative (Array.copy target); chance; transitions } :: !found
    in
    each drawn (begun w tuple) add;
    Some (Joint_draws.merged (List.rev !found))

exception Found of (int * Vec.t) list

let towards w tuple test =
  match drawn w tuple with
  | None -> None
  | Some drawn -> (
      let look target kicked _ =
        if test (Array.copy target) then
          let velocity i (slot, walker) =
            let _, v, _ = walker.kicks.(kicked.(i)) in
            (slot, v)
          in
          raise (Found (Array.to_list (Array.mapi velocity drawn.walkers)))
      in
      match each drawn (begun w tuple) look with
      | () -> None
      | exception Found velocities -> Some velocities)
