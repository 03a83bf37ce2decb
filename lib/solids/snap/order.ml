type t = { placed : int array; earlier : int array array; cost : int * int }

(* Lengths beyond this are all the same. *)
let most = 1 lsl 40

(* An element that lies on three earlier ones has numbers as long as all of theirs; one with fewer has free
   coordinates as well. *)
let make (i : Incidence.t) ~grid removed =
  let n = Incidence.size i in
  let placed = Array.init n (fun k -> removed.(n - 1 - k)) in
  let time = Array.make n 0 in
  Array.iteri (fun k u -> time.(u) <- k) placed;
  let earlier =
    Array.map
      (fun u -> Array.of_list (List.filter (fun w -> time.(w) < time.(u)) (Array.to_list i.neighbours.(u))))
      placed
  in
  let bits = Array.make n 0 in
  let longest = ref 0 and sum = ref 0 in
  Array.iteri
    (fun k u ->
       let own = if Array.length earlier.(k) < 3 then grid else 0 in
       let b = Int.min most (Array.fold_left (fun s w -> s + bits.(w)) own earlier.(k)) in
       bits.(u) <- b;
       longest := Int.max !longest b;
       sum := Int.min most (!sum + b))
    placed;
  { placed; earlier; cost = (!longest, !sum) }

(* {1 Removals: each element has at most three neighbours left when it goes} *)

let remove (i : Incidence.t) degree gone u =
  gone.(u) <- true;
  Array.iter (fun w -> if not gone.(w) then degree.(w) <- degree.(w) - 1) i.neighbours.(u)

let start (i : Incidence.t) = (Array.map Array.length i.neighbours, Array.make (Incidence.size i) false)

(* All faces that may go, all vertices that may, and so on. *)
let layers (i : Incidence.t) ~faces_first =
  let degree, gone = start i in
  let n = Incidence.size i in
  let is_face u = u >= i.vertices in
  let rec go removed count faces idle =
    if count = n then Some (Array.of_list (List.rev removed))
    else if idle = 2 then None
    else
      let may u = (not gone.(u)) && is_face u = faces && degree.(u) <= 3 in
      let layer = List.filter may (List.init n Fun.id) in
      List.iter (remove i degree gone) layer;
      let more = List.length layer in
      go (List.rev_append layer removed) (count + more) (not faces) (if more = 0 then idle + 1 else 0)
  in
  go [] 0 faces_first 0

(* Our own generator, so that all machines draw the same: the multiplier is Knuth's MMIX. *)
let draw state bound =
  state := Int64.add (Int64.mul !state 6364136223846793005L) 1442695040888963407L;
  Int64.to_int (Int64.rem (Int64.shift_right_logical !state 33) (Int64.of_int bound))

let by_chance (i : Incidence.t) state =
  let degree, gone = start i in
  let n = Incidence.size i in
  let ready = Array.make n 0 and count = ref 0 and known = Array.make n false in
  let offer u =
    if (not known.(u)) && (not gone.(u)) && degree.(u) <= 3 then begin
      known.(u) <- true;
      ready.(!count) <- u;
      incr count
    end
  in
  for u = 0 to n - 1 do
    offer u
  done;
  let rec go removed =
    if !count = 0 then if Array.for_all Fun.id gone then Some (Array.of_list (List.rev removed)) else None
    else begin
      let k = draw state !count in
      let u = ready.(k) in
      decr count;
      ready.(k) <- ready.(!count);
      remove i degree gone u;
      Array.iter offer i.neighbours.(u);
      go (u :: removed)
    end
  in
  go []

let tries = 300

let cheaper a b =
  let (x, y), (x', y') = (a.cost, b.cost) in
  Int.compare x x' <?> fun () -> Int.compare y y'

let best i ~grid ~count =
  let state = ref 1L in
  let removals =
    layers i ~faces_first:true :: layers i ~faces_first:false
    :: List.init tries (fun _ -> by_chance i state)
  in
  List.filter_map (Option.map (make i ~grid)) removals
  |> List.stable_sort cheaper
  |> List.filteri (fun k _ -> k < count)
