open Scc_exact
module Heap = Scc_data.Heap

module Table = Hashtbl.Make (struct
    type t = int

    let equal = Int.equal
    let hash i = i land max_int
  end)

type given_up = Interrupted | Too_long

exception Given_up of given_up

type t = {
  out : Rat.t Table.t array;  (** what each unknown asks for, of those that are left; not itself *)
  into : unit Table.t array;  (** who asks for it *)
  own : Rat.t array;  (** the diagonal *)
  constant : Rat.t array;
  left : bool array;
  heap : (int * int) Heap.t;  (** costs and unknowns; entries with a cost that is no longer right do not count *)
}

let cost s i = Table.length s.out.(i) * Table.length s.into.(i)
let wait s i = Heap.add s.heap (cost s i, i)

let compare_waiting (c, i) (d, j) =
  let order = Int.compare c d in
  if order <> 0 then order else Int.compare i j

let start ~size ~row ~constant =
  let s =
    {
      out = Array.init size (fun _ -> Table.create 4);
      into = Array.init size (fun _ -> Table.create 4);
      own = Array.make size Rat.zero;
      constant = Array.init size constant;
      left = Array.make size true;
      heap = Heap.create ~near:(fun (c, _) -> float_of_int c) ~compare:compare_waiting;
    }
  in
  for i = 0 to size - 1 do
    List.iter
      (fun (j, p) ->
         if Int.equal i j then s.own.(i) <- p
         else begin
           Table.replace s.out.(i) j p;
           Table.replace s.into.(j) i ()
         end)
      (row i)
  done;
  for i = 0 to size - 1 do
    wait s i
  done;
  s

let rec next s =
  match Heap.take s.heap with
  | None -> None
  | Some (c, i) -> if s.left.(i) && cost s i = c then Some i else next s

(* What an unknown is, by others that are left longer. *)
type solved = { unknown : int; at_least : Rat.t; others : (int * Rat.t) list }

(* In increasing order, so that the same is done in each run. *)
let pairs table =
  List.sort (fun (i, _) (j, _) -> Int.compare i j) (Table.fold (fun j p l -> (j, p) :: l) table [])

let eliminate s ~check i =
  let rest = Rat.sub Rat.one s.own.(i) in
  if Rat.sign rest <= 0 then Scc_base.Bug.fail __POS__ "an unknown that is never left";
  let share p = if Rat.equal rest Rat.one then p else Rat.div p rest in
  let others = List.map (fun (j, p) -> (j, share p)) (pairs s.out.(i)) in
  let constant = share s.constant.(i) in
  check constant;
  List.iter (fun (_, p) -> check p) others;
  s.left.(i) <- false;
  List.iter (fun (j, _) -> Table.remove s.into.(j) i) others;
  let askers = pairs s.into.(i) in
  List.iter
    (fun (k, ()) ->
       let p = Table.find s.out.(k) i in
       Table.remove s.out.(k) i;
       s.constant.(k) <- Rat.add s.constant.(k) (Rat.mul p constant);
       List.iter
         (fun (j, q) ->
            let more = Rat.mul p q in
            if Int.equal j k then s.own.(k) <- Rat.add s.own.(k) more
            else
              match Table.find_opt s.out.(k) j with
              | Some before -> Table.replace s.out.(k) j (Rat.add before more)
              | None ->
                Table.replace s.out.(k) j more;
                Table.replace s.into.(j) k ())
         others)
    askers;
  List.iter (fun (k, ()) -> wait s k) askers;
  List.iter (fun (j, _) -> wait s j) others;
  { unknown = i; at_least = constant; others }

(* From here on elimination makes more entries than it removes. *)
let fills s i = cost s i > Table.length s.out.(i) + Table.length s.into.(i)
let few = 40

(* Those that are left, as a system of their own. *)
let rest s ~bits ~interrupted =
  let left = List.filter (fun i -> s.left.(i)) (List.init (Array.length s.left) Fun.id) |> Array.of_list in
  let place = Table.create (Array.length left) in
  Array.iteri (fun k i -> Table.replace place i k) left;
  let row k =
    let i = left.(k) in
    (k, Rat.sub Rat.one s.own.(i)) :: List.map (fun (j, p) -> (Table.find place j, Rat.neg p)) (pairs s.out.(i))
  in
  let constant k = s.constant.(left.(k)) in
  match Lifting.solve ~size:(Array.length left) ~row ~constant ~bits ~interrupted with
  | Ok values -> Some (Array.to_list (Array.mapi (fun k x -> (left.(k), x)) values))
  | Error Interrupted -> raise (Given_up Interrupted)
  | Error Too_long -> raise (Given_up Too_long)
  | Error Unfit -> None

let solve ~size ~row ~constant ~bits ~interrupted =
  let check x = if Rat.bits x > bits then raise (Given_up Too_long) in
  let s = start ~size ~row ~constant in
  let rec go ~lifts ~left solved =
    if interrupted () then raise (Given_up Interrupted);
    match next s with
    | None -> (solved, [])
    | Some i when lifts && left > few && fills s i -> (
        match rest s ~bits ~interrupted with
        | Some known -> (solved, known)
        | None -> go ~lifts:false ~left:(left - 1) (eliminate s ~check i :: solved))
    | Some i -> go ~lifts ~left:(left - 1) (eliminate s ~check i :: solved)
  in
  match go ~lifts:true ~left:size [] with
  | exception Given_up why -> Error why
  | solved, known ->
    let x = Array.make size Rat.zero in
    List.iter (fun (i, value) -> x.(i) <- value) known;
    let value v =
      List.fold_left (fun sum (j, p) -> Rat.add sum (Rat.mul p x.(j))) v.at_least v.others
    in
    (* The last to be eliminated asks for nothing but what is known, and comes first here. *)
    List.iter (fun v -> x.(v.unknown) <- value v) solved;
    Ok x
