open Scc_codec

(* The ranks of a level are dealt out to owners in blocks. The first rank of a block: *)
let first ~width ~count owner = ((owner * width) + count - 1) / count

(* {1 What an owner tells of its new states} *)

let put_keys b ~keys ~from ~stop =
  Packed.put_nat b (stop - from);
  let last = ref 0 in
  for k = from to stop - 1 do
    let before, choice = keys k in
    Packed.put_nat b (before - !last);
    Packed.put_nat b choice;
    last := before
  done

let segments ~width ~count ~length ~before =
  (* The first place whose key is of a rank, or of a greater one. *)
  let rec search low high rank =
    if low >= high then low
    else
      let middle = (low + high) / 2 in
      if before middle < rank then search (middle + 1) high rank else search low middle rank
  in
  let starts = Array.init count (fun owner -> search 0 length (first ~width ~count owner)) in
  fun owner -> (starts.(owner), if owner + 1 < count then starts.(owner + 1) else length)

(* {1 What is made of it} *)

type key = { before : int; choice : int }

let read_keys source ~low ~high =
  let last = ref 0 in
  let count = Packed.nat source in
  let one _ =
    let before = !last + Packed.nat source in
    last := before;
    if before < low || before >= high then raise (Packed.Malformed "a key is of another block");
    { before; choice = Packed.nat source }
  in
  (* Each takes two bytes at least: no more are read than there are. *)
  List.init count one |> Array.of_list

(* The ranks of these keys among those of the block, by owner and in order: counted by the state before, and
   sorted by choice within each, of which there are few. *)
let rank_dense ~low ~high (keys : key array array) =
  let size = high - low in
  let starts = Array.make (size + 1) 0 in
  Array.iter (Array.iter (fun k -> starts.(k.before - low + 1) <- starts.(k.before - low + 1) + 1)) keys;
  for i = 1 to size do starts.(i) <- starts.(i) + starts.(i - 1) done;
  let total = starts.(size) in
  let filled = Array.sub starts 0 size in
  let choices = Array.make total 0 and owners = Array.make total 0 in
  (* Moves up those that come later. *)
  let rec insert start at choice owner =
    if at > start && choices.(at - 1) > choice then begin
      choices.(at) <- choices.(at - 1);
      owners.(at) <- owners.(at - 1);
      insert start (at - 1) choice owner
    end
    else begin
      choices.(at) <- choice;
      owners.(at) <- owner
    end
  in
  let put owner k =
    let i = k.before - low in
    insert starts.(i) filled.(i) k.choice owner;
    filled.(i) <- filled.(i) + 1
  in
  Array.iteri (fun owner -> Array.iter (put owner)) keys;
  let ranks = Array.map (fun of_owner -> Array.make (Array.length of_owner) 0) keys in
  let next = Array.make (Array.length keys) 0 in
  Array.iteri
    (fun rank owner ->
       ranks.(owner).(next.(owner)) <- rank;
       next.(owner) <- next.(owner) + 1)
    owners;
  (total, ranks)

(* Where few of the numbers of states before occur, these are numbered first. *)
let rank ~low ~high (keys : key array array) =
  let total = Array.fold_left (fun n of_owner -> n + Array.length of_owner) 0 keys in
  if high - low <= 16 * (total + 64) then rank_dense ~low ~high keys
  else begin
    let all = Array.concat (List.map (Array.map (fun k -> k.before)) (Array.to_list keys)) in
    Array.sort Int.compare all;
    let numbers = Hashtbl.create total in
    Array.iter
      (fun before -> if not (Hashtbl.mem numbers before) then Hashtbl.add numbers before (Hashtbl.length numbers))
      all;
    let renamed = Array.map (Array.map (fun k -> { k with before = Hashtbl.find numbers k.before })) keys in
    rank_dense ~low:0 ~high:(Hashtbl.length numbers) renamed
  end

let put_ranks b ~total ranks =
  Packed.put_nat b total;
  let put last rank =
    Packed.put_nat b (rank - last);
    rank
  in
  ignore (Array.fold_left put 0 ranks)

let read_ranks texts ~segment =
  let length = snd (segment (Array.length texts - 1)) in
  let ranks = Array.make length 0 in
  let block owner text sum =
    let source = Packed.source text in
    let total = Packed.nat source in
    let from, stop = segment owner in
    let last = ref sum in
    for k = from to stop - 1 do
      last := !last + Packed.nat source;
      ranks.(k) <- !last
    done;
    sum + total
  in
  let sum = ref 0 in
  Array.iteri (fun owner text -> sum := block owner text !sum) texts;
  ranks

(* {1 All together} *)

let written put =
  let b = Buffer.create 256 in
  put b;
  Buffer.contents b

let reading owner text read =
  match read (Packed.source text) with
  | x -> x
  | exception (Packed.Malformed what | Invalid_argument what) ->
    Failure.refused "owner %d: %s" (owner + 1) what

let of_all mesh ~width ~length ~keys ~mine ~put ~read =
  let count = Mesh.count mesh and me = Mesh.number mesh in
  let segment = segments ~width ~count ~length ~before:(fun k -> fst (keys k)) in
  let tell owner =
    let from, stop = segment owner in
    written (fun b ->
        put b mine;
        put_keys b ~keys ~from ~stop)
  in
  let low = first ~width ~count me and high = first ~width ~count (me + 1) in
  let read_told owner text =
    reading owner text (fun source ->
        let told = read source in
        (told, read_keys source ~low ~high))
  in
  let told = Array.mapi read_told (Mesh.gather mesh tell) in
  let total, ranks = rank ~low ~high (Array.map snd told) in
  let answer owner = written (fun b -> put_ranks b ~total ranks.(owner)) in
  let texts = Mesh.gather mesh answer in
  (Array.map fst told, reading me "" (fun _ -> read_ranks texts ~segment))

let agree mesh ~width ~length ~keys ~mine ~put ~read =
  if Mesh.count mesh > 1 then of_all mesh ~width ~length ~keys ~mine ~put ~read
  else ([| mine |], Array.init length Fun.id)
