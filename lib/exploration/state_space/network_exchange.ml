open Scc_codec

type context = Network_lts.context

let width = Network_lts.width
let catalogue = Network_lts.catalogue
let codec = Network_lts.codec

(* The families are the kinds of slots. *)
let families _ = 4

let family c slot : int =
  match Catalogue.slot (catalogue c) slot with Process -> 0 | Step -> 1 | Time -> 2 | Mark -> 3

let bytes put =
  let buffer = Buffer.create 64 in
  put buffer;
  Buffer.contents buffer

let component c ~family number =
  let catalogue = catalogue c in
  bytes (fun b ->
      match family with
      | 0 when number = Catalogue.nobody -> ()
      | 0 -> State_codec.put_process (codec c) b (Catalogue.body catalogue number).process
      | 1 -> State_codec.put_step b (Catalogue.step_of_number catalogue number)
      | 2 -> Packed.put_rational b (Catalogue.rational catalogue number)
      | _ -> Packed.put_list b Packed.put_nat (Network_lts.events_of_mark c number))

let reading text read =
  let source = Packed.source text in
  match
    let x = read source in
    if Packed.at_end source then x else failwith "there is more than was to be read"
  with
  | x -> x
  | exception Packed.Malformed what -> failwith what

let of_component c ~family text =
  let catalogue = catalogue c in
  match family with
  | 0 when String.equal text "" -> Catalogue.nobody
  | 0 -> Catalogue.process catalogue (reading text (State_codec.process (codec c)))
  | 1 -> Catalogue.step_number catalogue (reading text State_codec.step)
  | 2 -> Catalogue.rational_number catalogue (reading text Packed.rational)
  | _ -> Network_lts.mark_of c (reading text (fun s -> Packed.list s Packed.nat))

(* 0 and the label, and its chance if that is not its own; or the number of joined draws and their chance. *)
let name c label =
  let catalogue = catalogue c in
  bytes (fun b ->
      match Catalogue.single catalogue label with
      | Some l ->
        Packed.put_nat b 0;
        Label_codec.put (codec c) b l;
        if Catalogue.is_tied catalogue label then
          Packed.put_rational b (Option.get (Catalogue.chance catalogue label))
      | None ->
        Packed.put_nat b (Catalogue.transitions catalogue label);
        Packed.put_rational b (Option.get (Catalogue.chance catalogue label)))

let of_name c text =
  reading text (fun source ->
      match Packed.nat source with
      | 0 ->
        let label = Label_codec.read (codec c) source in
        if Packed.at_end source then Catalogue.label (catalogue c) label
        else Catalogue.tied (catalogue c) label (Packed.rational source)
      | transitions -> Catalogue.joint (catalogue c) { chance = Packed.rational source; transitions })
