type t = { order : int array; steps : int }

(* An eliminated unknown is an element: those that it was a neighbour of are neighbours of each other from then on,
   which only the list of them tells. An element that another one contains counts no more. *)
type graph = {
  unknowns : int array array;  (** neighbours of each unknown, but for those that an element tells *)
  elements : int list array;  (** the elements that each unknown belongs to *)
  members : int array array;  (** of each element that counts; empty for others *)
  gone : bool array;
  mark : int array;  (** the last unknown by which each was found *)
  outside : int array;  (** of an element: how many members it has outside of the last one, where [seen] says so *)
  seen : int array;
  degree : int array;
  (* Lists of the unknowns of each degree. *)
  head : int array;
  next : int array;
  before : int array;
  mutable work : int;  (** how often lists of neighbours were looked at *)
  mutable least : int;  (** no list of a smaller degree has an unknown *)
}

let insert g i =
  let d = g.degree.(i) in
  let first = g.head.(d) in
  g.next.(i) <- first;
  g.before.(i) <- -1;
  if first >= 0 then g.before.(first) <- i;
  g.head.(d) <- i;
  if d < g.least then g.least <- d

let remove g i =
  let next = g.next.(i) and before = g.before.(i) in
  if next >= 0 then g.before.(next) <- before;
  if before >= 0 then g.next.(before) <- next else g.head.(g.degree.(i)) <- next

(* What is a neighbour of very many would be looked at for each of them: it is eliminated last. *)
let is_dense size degree = degree > 16 && float_of_int degree > 10. *. sqrt (float_of_int size)

let start neighbours =
  let size = Array.length neighbours in
  let dense = Array.map (fun l -> is_dense size (Array.length l)) neighbours in
  let sparse l = Array.of_list (List.filter (fun j -> not dense.(j)) (Array.to_list l)) in
  let unknowns = Array.mapi (fun i l -> if dense.(i) then [||] else sparse l) neighbours in
  let g =
    {
      unknowns;
      elements = Array.make size [];
      members = Array.make size [||];
      gone = Array.copy dense;
      mark = Array.make size (-1);
      outside = Array.make size 0;
      seen = Array.make size (-1);
      degree = Array.map Array.length unknowns;
      head = Array.make (size + 1) (-1);
      next = Array.make size (-1);
      before = Array.make size (-1);
      work = 0;
      least = 0;
    }
  in
  for i = size - 1 downto 0 do
    if not dense.(i) then insert g i
  done;
  (g, dense)

let rec least g =
  if g.head.(g.least) >= 0 then g.head.(g.least)
  else begin
    g.least <- g.least + 1;
    least g
  end

(* The neighbours of an unknown, which make it an element; those that tell of them count no more. *)
let found g p =
  let all = ref [] in
  let add i =
    if (not g.gone.(i)) && g.mark.(i) <> p then begin
      g.mark.(i) <- p;
      all := i :: !all
    end
  in
  Array.iter add g.unknowns.(p);
  List.iter
    (fun e ->
       g.work <- g.work + Array.length g.members.(e);
       Array.iter add g.members.(e);
       g.members.(e) <- [||])
    g.elements.(p);
  g.unknowns.(p) <- [||];
  g.elements.(p) <- [];
  Array.of_list !all

let eliminate g p ~left =
  g.gone.(p) <- true;
  remove g p;
  let around = found g p in
  let count e =
    g.work <- g.work + 1;
    if g.seen.(e) <> p then begin
      g.seen.(e) <- p;
      g.outside.(e) <- Array.length g.members.(e)
    end;
    g.outside.(e) <- g.outside.(e) - 1
  in
  let counts e =
    g.work <- g.work + 1;
    Array.length g.members.(e) > 0
  in
  Array.iter
    (fun i ->
       g.elements.(i) <- List.filter counts g.elements.(i);
       List.iter count g.elements.(i))
    around;
  let update i =
    let others = List.filter (fun e -> g.outside.(e) > 0) g.elements.(i) in
    let unknowns = g.unknowns.(i) in
    g.work <- g.work + 1 + Array.length unknowns;
    let stays j = not (g.gone.(j) || g.mark.(j) = p) in
    let kept = if Array.for_all stays unknowns then unknowns
      else Array.of_list (List.filter stays (Array.to_list unknowns))
    in
    g.unknowns.(i) <- kept;
    g.elements.(i) <- p :: others;
    let far = List.fold_left (fun sum e -> sum + g.outside.(e)) 0 others in
    remove g i;
    g.degree.(i) <- Int.min (left - 1) (Array.length kept + Array.length around - 1 + far);
    insert g i
  in
  Array.iter update around;
  g.members.(p) <- around;
  Array.length around

(* A look at a list takes as long as so many products. Half of all steps may be for the order alone. *)
let per_look = 64
let share = 2

let compute ~neighbours ~most ~interrupted =
  let size = Array.length neighbours in
  let g, dense = start neighbours in
  let last = List.filter (Array.get dense) (List.init size Fun.id) in
  let few = List.length last in
  let order = Array.make size 0 in
  (* Where all that are left are neighbours of each other, any order does. *)
  let rec go k steps =
    if steps > most || per_look * g.work > most / share || (k land 0xff = 0 && interrupted ()) then None
    else if k = size - few then Some steps
    else
      let p = least g in
      order.(k) <- p;
      let left = size - few - k - 1 in
      let around = few + eliminate g p ~left in
      go (k + 1) (steps + (around * around))
  in
  match go 0 0 with
  | None -> None
  | Some steps ->
    List.iteri (fun i v -> order.(size - few + i) <- v) last;
    let steps = steps + (per_look * g.work) + (few * few * few) in
    if steps > most then None else Some { order; steps }
