// What web/export.js uses of WebCodecs, which the library of the compiler does not have.

interface EncodedVideoChunk {
  type: "key" | "delta";
  timestamp: number;
  byteLength: number;
  copyTo(to: Uint8Array): void;
}

interface VideoEncoderConfig {
  codec: string;
  width: number;
  height: number;
  framerate: number;
  bitrate: number;
}

declare class VideoFrame {
  constructor(image: HTMLCanvasElement, about: { timestamp: number; duration: number });
  close(): void;
}

declare class VideoEncoder {
  static isConfigSupported(config: VideoEncoderConfig): Promise<{ supported: boolean }>;
  constructor(init: { output: (chunk: EncodedVideoChunk) => void; error: (error: Error) => void });
  state: string;
  encodeQueueSize: number;
  configure(config: VideoEncoderConfig): void;
  encode(frame: VideoFrame, options: { keyFrame: boolean }): void;
  flush(): Promise<void>;
  close(): void;
}
