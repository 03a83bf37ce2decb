open Scc_data

type ends = { count : int; number : int array; internal : Bits.t }

let none m =
  { count = 0; number = Array.make (Mdp.states m) (-1); internal = Bits.create (Mdp.choices m) }

(* What is left of the part, and what is being looked at. *)
type rest = {
  back : Backwards.t;
  alive : Bits.t;  (** choices *)
  left : int array;  (** of each state, its choices that are alive; 0: the state is gone *)
  place : int array;  (** of a state that is looked at, its number among these; else -1 *)
  component : int array;  (** of a state: which part it was found in; parts are numbered by [fresh] *)
  mutable fresh : int;
  lost : Bits.t;  (** states that have lost a choice since they were looked at *)
}

(* A choice goes; when it was the last one of its state, so does that, with all choices into it. *)
let drop r c =
  let waiting = Int_queue.create () in
  let kill c =
    if Bits.mem r.alive c then begin
      Bits.remove r.alive c;
      let s = Backwards.owner r.back c in
      Bits.add r.lost s;
      r.left.(s) <- r.left.(s) - 1;
      if r.left.(s) = 0 then Int_queue.push waiting s
    end
  in
  kill c;
  let rec go () =
    match Int_queue.take waiting with
    | None -> ()
    | Some s ->
      Backwards.iter r.back s kill;
      go ()
  in
  go ()

let choices_of m s f =
  for c = Mdp.first_choice m s to Mdp.first_choice m (s + 1) - 1 do
    f c
  done

(* The strong components of what is alive among some states, as lists of them. *)
let split r nodes =
  let m = Backwards.mdp r.back in
  Array.iteri
    (fun i s ->
       r.place.(s) <- i;
       Bits.remove r.lost s)
    nodes;
  let successors i =
    let found = ref [] in
    choices_of m nodes.(i) (fun c ->
        if Bits.mem r.alive c then
          for b = Mdp.first_branch m c to Mdp.first_branch m (c + 1) - 1 do
            found := r.place.(Mdp.target m b) :: !found
          done);
    Array.of_list !found
  in
  let strong =
    Strong_components.compute ~size:(Array.length nodes) ~inside:(fun i -> i >= 0) ~successors
  in
  let parts = Array.make (Strong_components.count strong) [] in
  Strong_components.iter strong (fun k i -> parts.(k) <- nodes.(i) :: parts.(k));
  Array.iter (fun s -> r.place.(s) <- -1) nodes;
  Array.iter
    (fun part ->
       List.iter (fun s -> r.component.(s) <- r.fresh) part;
       r.fresh <- r.fresh + 1)
    parts;
  parts

(* Drops the choices that leave the part. *)
let cut r part =
  let m = Backwards.mdp r.back in
  List.iter
    (fun s ->
       choices_of m s (fun c ->
           if Bits.mem r.alive c then begin
             let same t = r.left.(t) > 0 && r.component.(t) = r.component.(s) in
             if not (Mdp.every_branch m c same) then drop r c
           end))
    part

(* The components of what is left. *)
let found r =
  let m = Backwards.mdp r.back in
  let n = Mdp.states m in
  let final = Growable.create () in
  let living states = Array.of_list (List.filter (fun s -> r.left.(s) > 0) states) in
  let rec go = function
    | [] -> ()
    | nodes :: waiting when Array.length nodes = 0 -> go waiting
    | nodes :: waiting ->
      (* All parts are cut before any is looked at again: a choice that leads to several may be lost by any. *)
      let parts = split r nodes in
      Array.iter (cut r) parts;
      let again = ref waiting in
      Array.iter
        (fun part ->
           if List.exists (Bits.mem r.lost) part then again := living part :: !again
           else Growable.push final part)
        parts;
      go !again
  in
  go [ living (List.init n Fun.id) ];
  let number = Array.make n (-1) in
  for k = 0 to Growable.length final - 1 do
    List.iter (fun s -> number.(s) <- k) (Growable.get final k)
  done;
  { count = Growable.length final; number; internal = r.alive }

(* Drops the choices that lead to what is gone, as far as passes find them: whether that was all. *)
let drop_by_passes m ~alive ~left =
  let leads_away c =
    let last = Mdp.first_branch m (c + 1) in
    let rec go b = b < last && (left.(Mdp.target m b) = 0 || go (b + 1)) in
    go (Mdp.first_branch m c)
  in
  Passes.run ~size:(Mdp.states m) (fun s ->
      left.(s) > 0
      && begin
        for c = Mdp.first_choice m s to Mdp.first_choice m (s + 1) - 1 do
          if Bits.mem alive c && leads_away c then begin
            Bits.remove alive c;
            left.(s) <- left.(s) - 1
          end
        done;
        left.(s) = 0
      end)

let ends back ~inside ~allowed =
  let m = Backwards.mdp back in
  let n = Mdp.states m in
  let alive = Bits.create (Mdp.choices m) and left = Array.make n 0 in
  let inner = Bits.init n inside in
  for s = 0 to n - 1 do
    if Bits.mem inner s then
      choices_of m s (fun c ->
          if allowed c && Mdp.stays_in m c inner then begin
            Bits.add alive c;
            left.(s) <- left.(s) + 1
          end)
  done;
  let all_dropped = drop_by_passes m ~alive ~left in
  if all_dropped && Array.for_all (Int.equal 0) left then none m
  else begin
    let unknown = Array.make n (-1) in
    let r =
      { back; alive; left; place = unknown; component = Array.copy unknown; fresh = 0; lost = Bits.create n }
    in
    if not all_dropped then
      for s = 0 to n - 1 do
        if Bits.mem inner s && left.(s) = 0 then
          Backwards.iter back s (fun c -> if Bits.mem alive c then drop r c)
      done;
    found r
  end
