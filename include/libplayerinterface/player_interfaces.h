#pragma once

// Made by scripts/player_messages.py from src/wire/player/interfaces.def: edit that.

// Player's structs and constants under their own names, for programs that use them (specs:
// player.md A.1). Counted arrays are a count and a pointer; whoever makes one owns what it points
// to. Units: m, rad, s, V, A, W unless an interface says otherwise.

#include <cstddef>
#include <cstdint>

// NOLINTBEGIN(modernize-use-using,cppcoreguidelines-macro-usage,modernize-macro-to-enum)

#define PLAYER_MSGTYPE_DATA 1
#define PLAYER_MSGTYPE_CMD 2
#define PLAYER_MSGTYPE_REQ 3
#define PLAYER_MSGTYPE_RESP_ACK 4
#define PLAYER_MSGTYPE_SYNCH 5
#define PLAYER_MSGTYPE_RESP_NACK 6

#define PLAYER_MAX_DRIVER_STRING_LEN 64
#define PLAYER_MAX_DEVICES 4096
#define PLAYER_KEYLEN 32

#define PLAYER_CAPABILTIES_REQ 255
#define PLAYER_GET_INTPROP_REQ 254
#define PLAYER_SET_INTPROP_REQ 253
#define PLAYER_GET_DBLPROP_REQ 252
#define PLAYER_SET_DBLPROP_REQ 251
#define PLAYER_GET_STRPROP_REQ 250
#define PLAYER_SET_STRPROP_REQ 249
#define PLAYER_GET_BOOLPROP_REQ 248
#define PLAYER_SET_BOOLPROP_REQ 247

typedef struct player_bool {
  std::uint8_t state;
} player_bool_t;

typedef struct player_color {
  std::uint8_t alpha;
  std::uint8_t red;
  std::uint8_t green;
  std::uint8_t blue;
} player_color_t;

typedef struct player_point_2d {
  double px;
  double py;
} player_point_2d_t;

typedef struct player_point_3d {
  double px;
  double py;
  double pz;
} player_point_3d_t;

typedef struct player_orientation_3d {
  double proll;
  double ppitch;
  double pyaw;
} player_orientation_3d_t;

typedef struct player_pose2d {
  double px;
  double py;
  double pa;
} player_pose2d_t;

typedef struct player_pose3d {
  double px;
  double py;
  double pz;
  double proll;
  double ppitch;
  double pyaw;
} player_pose3d_t;

typedef struct player_bbox2d {
  double sw;
  double sl;
} player_bbox2d_t;

typedef struct player_bbox3d {
  double sw;
  double sl;
  double sh;
} player_bbox3d_t;

typedef struct player_segment {
  double x0;
  double y0;
  double x1;
  double y1;
} player_segment_t;

typedef struct player_extent2d {
  double x0;
  double y0;
  double x1;
  double y1;
} player_extent2d_t;

typedef struct player_devaddr {
  std::uint32_t host;
  std::uint32_t robot;
  std::uint16_t interf;
  std::uint16_t index;
} player_devaddr_t;

typedef struct player_capabilities_req {
  std::uint32_t type;
  std::uint32_t subtype;
} player_capabilities_req_t;

typedef struct player_boolprop_req {
  std::uint32_t key_count;
  char* key;
  std::uint8_t value;
} player_boolprop_req_t;

typedef struct player_intprop_req {
  std::uint32_t key_count;
  char* key;
  std::int32_t value;
} player_intprop_req_t;

typedef struct player_dblprop_req {
  std::uint32_t key_count;
  char* key;
  double value;
} player_dblprop_req_t;

typedef struct player_strprop_req {
  std::uint32_t key_count;
  char* key;
  std::uint32_t value_count;
  char* value;
} player_strprop_req_t;

#define PLAYER_PLAYER_CODE 1
#define PLAYER_PLAYER_STRING "player"
#define PLAYER_PLAYER_REQ_DEVLIST 1
#define PLAYER_PLAYER_REQ_DRIVERINFO 2
#define PLAYER_PLAYER_REQ_DEV 3
#define PLAYER_PLAYER_REQ_DATA 4
#define PLAYER_PLAYER_REQ_DATAMODE 5
#define PLAYER_PLAYER_REQ_AUTH 7
#define PLAYER_PLAYER_REQ_NAMESERVICE 8
#define PLAYER_PLAYER_REQ_ADD_REPLACE_RULE 10
#define PLAYER_PLAYER_SYNCH_OK 1
#define PLAYER_PLAYER_SYNCH_OVERFLOW 2

typedef struct player_device_devlist {
  std::uint32_t devices_count;
  player_devaddr_t devices[4096];
} player_device_devlist_t;

typedef struct player_device_driverinfo {
  player_devaddr_t addr;
  std::uint32_t driver_name_count;
  char driver_name[64];
} player_device_driverinfo_t;

typedef struct player_device_req {
  player_devaddr_t addr;
  std::uint8_t access;
  std::uint32_t driver_name_count;
  char driver_name[64];
} player_device_req_t;

typedef struct player_device_datamode_req {
  std::uint8_t mode;
} player_device_datamode_req_t;

typedef struct player_device_auth_req {
  std::uint32_t auth_key_count;
  char auth_key[32];
} player_device_auth_req_t;

typedef struct player_device_nameservice_req {
  std::uint32_t name_count;
  char name[64];
  std::uint16_t port;
} player_device_nameservice_req_t;

typedef struct player_add_replace_rule_req {
  std::int32_t interf;
  std::int32_t index;
  std::int32_t type;
  std::int32_t subtype;
  std::int32_t replace;
} player_add_replace_rule_req_t;

typedef struct player_overflow {
  std::uint32_t dropped;
} player_overflow_t;
#define PLAYER_OPEN_MODE 1
#define PLAYER_CLOSE_MODE 2
#define PLAYER_ERROR_MODE 3
#define PLAYER_DATAMODE_PUSH 1
#define PLAYER_DATAMODE_PULL 2
#define PLAYER_PLAYER_MSG_REPLACE_RULE_ACCEPT 0
#define PLAYER_PLAYER_MSG_REPLACE_RULE_REPLACE 1
#define PLAYER_PLAYER_MSG_REPLACE_RULE_IGNORE 2

#define PLAYER_POWER_CODE 2
#define PLAYER_POWER_STRING "power"
#define PLAYER_POWER_DATA_STATE 1
#define PLAYER_POWER_REQ_SET_CHARGING_POLICY 1

typedef struct player_power_data {
  std::uint32_t valid;
  float volts;
  float percent;
  float joules;
  float watts;
  std::int32_t charging;
} player_power_data_t;

typedef struct player_power_chargepolicy_config {
  std::uint8_t enable_input;
  std::uint8_t enable_output;
} player_power_chargepolicy_config_t;
#define PLAYER_POWER_MASK_VOLTS 1
#define PLAYER_POWER_MASK_WATTS 2
#define PLAYER_POWER_MASK_JOULES 4
#define PLAYER_POWER_MASK_PERCENT 8
#define PLAYER_POWER_MASK_CHARGING 16

#define PLAYER_GRIPPER_CODE 3
#define PLAYER_GRIPPER_STRING "gripper"
#define PLAYER_GRIPPER_DATA_STATE 1
#define PLAYER_GRIPPER_REQ_GET_GEOM 1
#define PLAYER_GRIPPER_CMD_OPEN 1
#define PLAYER_GRIPPER_CMD_CLOSE 2
#define PLAYER_GRIPPER_CMD_STOP 3
#define PLAYER_GRIPPER_CMD_STORE 4
#define PLAYER_GRIPPER_CMD_RETRIEVE 5

typedef struct player_gripper_data {
  std::uint8_t state;
  std::uint32_t beams;
  std::uint8_t stored;
} player_gripper_data_t;

typedef struct player_gripper_geom {
  player_pose3d_t pose;
  player_bbox3d_t outer_size;
  player_bbox3d_t inner_size;
  std::uint8_t num_beams;
  std::uint8_t capacity;
} player_gripper_geom_t;
#define PLAYER_GRIPPER_STATE_OPEN 1
#define PLAYER_GRIPPER_STATE_CLOSED 2
#define PLAYER_GRIPPER_STATE_MOVING 3
#define PLAYER_GRIPPER_STATE_ERROR 4

#define PLAYER_POSITION2D_CODE 4
#define PLAYER_POSITION2D_STRING "position2d"
#define PLAYER_POSITION2D_REQ_GET_GEOM 1
#define PLAYER_POSITION2D_REQ_MOTOR_POWER 2
#define PLAYER_POSITION2D_REQ_VELOCITY_MODE 3
#define PLAYER_POSITION2D_REQ_POSITION_MODE 4
#define PLAYER_POSITION2D_REQ_SET_ODOM 5
#define PLAYER_POSITION2D_REQ_RESET_ODOM 6
#define PLAYER_POSITION2D_REQ_SPEED_PID 7
#define PLAYER_POSITION2D_REQ_POSITION_PID 8
#define PLAYER_POSITION2D_REQ_SPEED_PROF 9
#define PLAYER_POSITION2D_DATA_STATE 1
#define PLAYER_POSITION2D_DATA_GEOM 2
#define PLAYER_POSITION2D_CMD_VEL 1
#define PLAYER_POSITION2D_CMD_POS 2
#define PLAYER_POSITION2D_CMD_CAR 3
#define PLAYER_POSITION2D_CMD_VEL_HEAD 4

typedef struct player_position2d_data {
  player_pose2d_t pos;
  player_pose2d_t vel;
  std::uint8_t stall;
} player_position2d_data_t;

typedef struct player_position2d_cmd_vel {
  player_pose2d_t vel;
  std::uint8_t state;
} player_position2d_cmd_vel_t;

typedef struct player_position2d_cmd_pos {
  player_pose2d_t pos;
  player_pose2d_t vel;
  std::uint8_t state;
} player_position2d_cmd_pos_t;

typedef struct player_position2d_cmd_car {
  double velocity;
  double angle;
} player_position2d_cmd_car_t;

typedef struct player_position2d_cmd_vel_head {
  double velocity;
  double angle;
} player_position2d_cmd_vel_head_t;

typedef struct player_position2d_geom {
  player_pose3d_t pose;
  player_bbox3d_t size;
} player_position2d_geom_t;

typedef struct player_position2d_power_config {
  std::uint8_t state;
} player_position2d_power_config_t;

typedef struct player_position2d_velocity_mode_config {
  std::uint32_t value;
} player_position2d_velocity_mode_config_t;

typedef struct player_position2d_position_mode_req {
  std::uint32_t state;
} player_position2d_position_mode_req_t;

typedef struct player_position2d_set_odom_req {
  player_pose2d_t pose;
} player_position2d_set_odom_req_t;

typedef struct player_position2d_speed_pid_req {
  float kp;
  float ki;
  float kd;
} player_position2d_speed_pid_req_t;

typedef struct player_position2d_position_pid_req {
  float kp;
  float ki;
  float kd;
} player_position2d_position_pid_req_t;

typedef struct player_position2d_speed_prof_req {
  float speed;
  float acc;
} player_position2d_speed_prof_req_t;

#define PLAYER_SONAR_CODE 5
#define PLAYER_SONAR_STRING "sonar"
#define PLAYER_SONAR_REQ_GET_GEOM 1
#define PLAYER_SONAR_REQ_POWER 2
#define PLAYER_SONAR_DATA_RANGES 1
#define PLAYER_SONAR_DATA_GEOM 2

typedef struct player_sonar_data {
  std::uint32_t ranges_count;
  float* ranges;
} player_sonar_data_t;

typedef struct player_sonar_geom {
  std::uint32_t poses_count;
  player_pose3d_t* poses;
} player_sonar_geom_t;

typedef struct player_sonar_power_config {
  std::uint8_t state;
} player_sonar_power_config_t;

#define PLAYER_LASER_CODE 6
#define PLAYER_LASER_STRING "laser"
#define PLAYER_LASER_DATA_SCAN 1
#define PLAYER_LASER_DATA_SCANPOSE 2
#define PLAYER_LASER_DATA_SCANANGLE 3
#define PLAYER_LASER_REQ_GET_GEOM 1
#define PLAYER_LASER_REQ_SET_CONFIG 2
#define PLAYER_LASER_REQ_GET_CONFIG 3
#define PLAYER_LASER_REQ_POWER 4
#define PLAYER_LASER_REQ_GET_ID 5
#define PLAYER_LASER_REQ_SET_FILTER 6

typedef struct player_laser_data {
  float min_angle;
  float max_angle;
  float resolution;
  float max_range;
  std::uint32_t ranges_count;
  float* ranges;
  std::uint32_t intensity_count;
  std::uint8_t* intensity;
  std::uint32_t id;
} player_laser_data_t;

typedef struct player_laser_data_scanpose {
  player_laser_data_t scan;
  player_pose2d_t pose;
} player_laser_data_scanpose_t;

typedef struct player_laser_data_scanangle {
  float max_range;
  std::uint32_t ranges_count;
  float* ranges;
  std::uint32_t angles_count;
  float* angles;
  std::uint32_t intensity_count;
  std::uint8_t* intensity;
  std::uint32_t id;
} player_laser_data_scanangle_t;

typedef struct player_laser_geom {
  player_pose3d_t pose;
  player_bbox3d_t size;
} player_laser_geom_t;

typedef struct player_laser_config {
  float min_angle;
  float max_angle;
  float resolution;
  float max_range;
  float range_res;
  std::uint8_t intensity;
  float scanning_frequency;
} player_laser_config_t;

typedef struct player_laser_power_config {
  std::uint8_t state;
} player_laser_power_config_t;

typedef struct player_laser_get_id_config {
  std::uint32_t serial_number;
} player_laser_get_id_config_t;

typedef struct player_laser_set_filter_config {
  std::uint8_t filter_type;
  std::uint32_t parameters_count;
  float parameters[8];
} player_laser_set_filter_config_t;
#define PLAYER_LASER_MAX_FILTER_PARAMS 8
#define PLAYER_LASER_FILTER_MEDIAN 1
#define PLAYER_LASER_FILTER_EDGE 2
#define PLAYER_LASER_FILTER_RANGE 3
#define PLAYER_LASER_FILTER_MEAN 4

#define PLAYER_BLOBFINDER_CODE 7
#define PLAYER_BLOBFINDER_STRING "blobfinder"
#define PLAYER_BLOBFINDER_DATA_BLOBS 1
#define PLAYER_BLOBFINDER_REQ_SET_COLOR 1
#define PLAYER_BLOBFINDER_REQ_SET_IMAGER_PARAMS 2
#define PLAYER_BLOBFINDER_REQ_GET_COLOR 3

typedef struct player_blobfinder_blob {
  std::uint32_t id;
  std::uint32_t color;
  std::uint32_t area;
  std::uint32_t x;
  std::uint32_t y;
  std::uint32_t left;
  std::uint32_t right;
  std::uint32_t top;
  std::uint32_t bottom;
  float range;
} player_blobfinder_blob_t;

typedef struct player_blobfinder_data {
  std::uint32_t width;
  std::uint32_t height;
  std::uint32_t blobs_count;
  player_blobfinder_blob_t* blobs;
} player_blobfinder_data_t;

typedef struct player_blobfinder_color_config {
  std::uint32_t channel;
  std::uint32_t rmin;
  std::uint32_t rmax;
  std::uint32_t gmin;
  std::uint32_t gmax;
  std::uint32_t bmin;
  std::uint32_t bmax;
} player_blobfinder_color_config_t;

typedef struct player_blobfinder_imager_config {
  std::int32_t brightness;
  std::int32_t contrast;
  std::int32_t colormode;
  std::int32_t autogain;
} player_blobfinder_imager_config_t;

#define PLAYER_PTZ_CODE 8
#define PLAYER_PTZ_STRING "ptz"
#define PLAYER_PTZ_REQ_GENERIC 1
#define PLAYER_PTZ_REQ_CONTROL_MODE 2
#define PLAYER_PTZ_REQ_GEOM 4
#define PLAYER_PTZ_REQ_STATUS 5
#define PLAYER_PTZ_DATA_STATE 1
#define PLAYER_PTZ_DATA_GEOM 2
#define PLAYER_PTZ_CMD_STATE 1

typedef struct player_ptz_data {
  float pan;
  float tilt;
  float zoom;
  float panspeed;
  float tiltspeed;
  std::uint32_t status;
} player_ptz_data_t;

typedef struct player_ptz_cmd {
  float pan;
  float tilt;
  float zoom;
  float panspeed;
  float tiltspeed;
} player_ptz_cmd_t;

typedef struct player_ptz_req_status {
  std::uint32_t status;
} player_ptz_req_status_t;

typedef struct player_ptz_geom {
  player_pose3d_t pos;
  player_bbox3d_t size;
} player_ptz_geom_t;

typedef struct player_ptz_req_generic {
  std::uint32_t config_count;
  std::uint32_t* config;
} player_ptz_req_generic_t;

typedef struct player_ptz_req_control_mode {
  std::uint32_t mode;
} player_ptz_req_control_mode_t;
#define PLAYER_PTZ_VELOCITY_CONTROL 0
#define PLAYER_PTZ_POSITION_CONTROL 1

#define PLAYER_AUDIO_CODE 9
#define PLAYER_AUDIO_STRING "audio"
#define PLAYER_AUDIO_DATA_WAV_REC 1
#define PLAYER_AUDIO_DATA_SEQ 2
#define PLAYER_AUDIO_DATA_MIXER_CHANNEL 3
#define PLAYER_AUDIO_DATA_STATE 4
#define PLAYER_AUDIO_CMD_WAV_PLAY 1
#define PLAYER_AUDIO_CMD_WAV_STREAM_REC 2
#define PLAYER_AUDIO_CMD_SAMPLE_PLAY 3
#define PLAYER_AUDIO_CMD_SEQ_PLAY 4
#define PLAYER_AUDIO_CMD_MIXER_CHANNEL 5
#define PLAYER_AUDIO_REQ_WAV_REC 1
#define PLAYER_AUDIO_REQ_SAMPLE_LOAD 2
#define PLAYER_AUDIO_REQ_SAMPLE_RETRIEVE 3
#define PLAYER_AUDIO_REQ_SAMPLE_REC 4
#define PLAYER_AUDIO_REQ_MIXER_CHANNEL_LIST 5
#define PLAYER_AUDIO_REQ_MIXER_CHANNEL_LEVEL 6

typedef struct player_audio_wav {
  std::uint32_t data_count;
  std::uint8_t* data;
  std::uint32_t format;
} player_audio_wav_t;

typedef struct player_audio_seq_item {
  float freq;
  float duration;
  float amplitude;
  player_bool_t link;
} player_audio_seq_item_t;

typedef struct player_audio_seq {
  std::uint32_t tones_count;
  player_audio_seq_item_t* tones;
} player_audio_seq_t;

typedef struct player_audio_mixer_channel {
  float amplitude;
  player_bool_t active;
  std::uint32_t index;
} player_audio_mixer_channel_t;

typedef struct player_audio_mixer_channel_list {
  std::uint32_t channels_count;
  player_audio_mixer_channel_t* channels;
} player_audio_mixer_channel_list_t;

typedef struct player_audio_mixer_channel_detail {
  std::uint32_t name_count;
  char* name;
  std::uint8_t caps;
} player_audio_mixer_channel_detail_t;

typedef struct player_audio_mixer_channel_list_detail {
  std::uint32_t details_count;
  player_audio_mixer_channel_detail_t* details;
  std::int32_t default_output;
  std::int32_t default_input;
} player_audio_mixer_channel_list_detail_t;

typedef struct player_audio_sample {
  player_audio_wav_t sample;
  std::int32_t index;
} player_audio_sample_t;

typedef struct player_audio_sample_item {
  std::int32_t index;
} player_audio_sample_item_t;

typedef struct player_audio_sample_rec_req {
  std::int32_t index;
  std::uint32_t length;
} player_audio_sample_rec_req_t;

typedef struct player_audio_state {
  std::uint32_t state;
} player_audio_state_t;
#define PLAYER_AUDIO_STATE_STOPPED 0x00
#define PLAYER_AUDIO_STATE_PLAYING 0x01
#define PLAYER_AUDIO_STATE_RECORDING 0x02
#define PLAYER_AUDIO_DESCRIPTION_BITS 0xFF
#define PLAYER_AUDIO_BITS 0x03
#define PLAYER_AUDIO_8BIT 0
#define PLAYER_AUDIO_16BIT 1
#define PLAYER_AUDIO_24BIT 2
#define PLAYER_AUDIO_MONO 0
#define PLAYER_AUDIO_STEREO 4
#define PLAYER_AUDIO_FREQ 0x18
#define PLAYER_AUDIO_FREQ_44k 0
#define PLAYER_AUDIO_FREQ_11k 8
#define PLAYER_AUDIO_FREQ_22k 16
#define PLAYER_AUDIO_FREQ_48k 24
#define PLAYER_AUDIO_FORMAT_BITS 0xFF00
#define PLAYER_AUDIO_FORMAT_NULL 0x0000
#define PLAYER_AUDIO_FORMAT_RAW 0x0100
#define PLAYER_AUDIO_FORMAT_MP3 0x0200
#define PLAYER_AUDIO_FORMAT_OGG 0x0300
#define PLAYER_AUDIO_FORMAT_FLAC 0x0400
#define PLAYER_AUDIO_FORMAT_AAC 0x0500
#define PLAYER_AUDIO_MIXER_CHANNEL_TYPE_INPUT 1
#define PLAYER_AUDIO_MIXER_CHANNEL_TYPE_OUTPUT 2
#define PLAYER_AUDIO_MIXER_CHANNEL_TYPE_SPECIAL 4

#define PLAYER_FIDUCIAL_CODE 10
#define PLAYER_FIDUCIAL_STRING "fiducial"
#define PLAYER_FIDUCIAL_DATA_SCAN 1
#define PLAYER_FIDUCIAL_REQ_GET_GEOM 1
#define PLAYER_FIDUCIAL_REQ_GET_FOV 2
#define PLAYER_FIDUCIAL_REQ_SET_FOV 3
#define PLAYER_FIDUCIAL_REQ_GET_ID 7
#define PLAYER_FIDUCIAL_REQ_SET_ID 8

typedef struct player_fiducial_item {
  std::int32_t id;
  player_pose3d_t pose;
  player_pose3d_t upose;
} player_fiducial_item_t;

typedef struct player_fiducial_data {
  std::uint32_t fiducials_count;
  player_fiducial_item_t* fiducials;
} player_fiducial_data_t;

typedef struct player_fiducial_geom {
  player_pose3d_t pose;
  player_bbox3d_t size;
  player_bbox2d_t fiducial_size;
} player_fiducial_geom_t;

typedef struct player_fiducial_fov {
  float min_range;
  float max_range;
  float view_angle;
} player_fiducial_fov_t;

typedef struct player_fiducial_id {
  std::uint32_t id;
} player_fiducial_id_t;

#define PLAYER_SPEECH_CODE 12
#define PLAYER_SPEECH_STRING "speech"
#define PLAYER_SPEECH_CMD_SAY 1

typedef struct player_speech_cmd {
  std::uint32_t string_count;
  char* string;
} player_speech_cmd_t;

#define PLAYER_GPS_CODE 13
#define PLAYER_GPS_STRING "gps"
#define PLAYER_GPS_DATA_STATE 1

typedef struct player_gps_data {
  std::uint32_t time_sec;
  std::uint32_t time_usec;
  std::int32_t latitude;
  std::int32_t longitude;
  std::int32_t altitude;
  double speed;
  double course;
  double utm_e;
  double utm_n;
  std::uint32_t quality;
  std::uint32_t num_sats;
  std::uint32_t hdop;
  std::uint32_t vdop;
  double err_horz;
  double err_vert;
} player_gps_data_t;

#define PLAYER_BUMPER_CODE 14
#define PLAYER_BUMPER_STRING "bumper"
#define PLAYER_BUMPER_DATA_STATE 1
#define PLAYER_BUMPER_DATA_GEOM 2
#define PLAYER_BUMPER_REQ_GET_GEOM 1

typedef struct player_bumper_data {
  std::uint32_t bumpers_count;
  std::uint8_t* bumpers;
} player_bumper_data_t;

typedef struct player_bumper_define {
  player_pose3d_t pose;
  float length;
  float radius;
} player_bumper_define_t;

typedef struct player_bumper_geom {
  std::uint32_t bumper_def_count;
  player_bumper_define_t* bumper_def;
} player_bumper_geom_t;

#define PLAYER_DIO_CODE 20
#define PLAYER_DIO_STRING "dio"
#define PLAYER_DIO_DATA_VALUES 1
#define PLAYER_DIO_CMD_VALUES 1

typedef struct player_dio_data {
  std::uint32_t count;
  std::uint32_t bits;
} player_dio_data_t;

typedef struct player_dio_cmd {
  std::uint32_t count;
  std::uint32_t digout;
} player_dio_cmd_t;

#define PLAYER_AIO_CODE 21
#define PLAYER_AIO_STRING "aio"
#define PLAYER_AIO_CMD_STATE 1
#define PLAYER_AIO_DATA_STATE 1

typedef struct player_aio_data {
  std::uint32_t voltages_count;
  float* voltages;
} player_aio_data_t;

typedef struct player_aio_cmd {
  std::uint32_t id;
  float voltage;
} player_aio_cmd_t;

#define PLAYER_IR_CODE 22
#define PLAYER_IR_STRING "ir"
#define PLAYER_IR_REQ_POSE 1
#define PLAYER_IR_REQ_POWER 2
#define PLAYER_IR_DATA_RANGES 1

typedef struct player_ir_data {
  std::uint32_t voltages_count;
  float* voltages;
  std::uint32_t ranges_count;
  float* ranges;
} player_ir_data_t;

typedef struct player_ir_pose {
  std::uint32_t poses_count;
  player_pose3d_t* poses;
} player_ir_pose_t;

typedef struct player_ir_power_req {
  std::uint8_t state;
} player_ir_power_req_t;

#define PLAYER_WIFI_CODE 23
#define PLAYER_WIFI_STRING "wifi"
#define PLAYER_WIFI_REQ_MAC 1
#define PLAYER_WIFI_REQ_IWSPY_ADD 2
#define PLAYER_WIFI_REQ_IWSPY_DEL 3
#define PLAYER_WIFI_REQ_IWSPY_PING 4
#define PLAYER_WIFI_DATA_STATE 1

typedef struct player_wifi_link {
  std::uint32_t mac_count;
  std::uint8_t mac[32];
  std::uint32_t ip_count;
  std::uint8_t ip[32];
  std::uint32_t essid_count;
  std::uint8_t essid[32];
  std::uint32_t mode;
  std::uint32_t freq;
  std::uint32_t encrypt;
  std::uint32_t qual;
  std::uint32_t level;
  std::uint32_t noise;
} player_wifi_link_t;

typedef struct player_wifi_data {
  std::uint32_t links_count;
  player_wifi_link_t* links;
  std::uint32_t throughput;
  std::uint32_t bitrate;
  std::uint32_t mode;
  std::uint32_t qual_type;
  std::uint32_t maxqual;
  std::uint32_t maxlevel;
  std::uint32_t maxnoise;
  std::uint8_t ap[32];
} player_wifi_data_t;

typedef struct player_wifi_mac_req {
  std::uint32_t mac_count;
  std::uint8_t mac[32];
} player_wifi_mac_req_t;

typedef struct player_wifi_iwspy_addr_req {
  std::uint8_t address[32];
} player_wifi_iwspy_addr_req_t;
#define PLAYER_WIFI_QUAL_DBM 1
#define PLAYER_WIFI_QUAL_REL 2
#define PLAYER_WIFI_QUAL_UNKNOWN 3
#define PLAYER_WIFI_MODE_UNKNOWN 0
#define PLAYER_WIFI_MODE_AUTO 1
#define PLAYER_WIFI_MODE_ADHOC 2
#define PLAYER_WIFI_MODE_INFRA 3
#define PLAYER_WIFI_MODE_MASTER 4
#define PLAYER_WIFI_MODE_REPEAT 5
#define PLAYER_WIFI_MODE_SECOND 6

#define PLAYER_LOCALIZE_CODE 25
#define PLAYER_LOCALIZE_STRING "localize"
#define PLAYER_LOCALIZE_DATA_HYPOTHS 1
#define PLAYER_LOCALIZE_REQ_SET_POSE 1
#define PLAYER_LOCALIZE_REQ_GET_PARTICLES 2

typedef struct player_localize_hypoth {
  player_pose2d_t mean;
  double cov[6];
  double alpha;
} player_localize_hypoth_t;

typedef struct player_localize_data {
  std::uint32_t pending_count;
  double pending_time;
  std::uint32_t hypoths_count;
  player_localize_hypoth_t* hypoths;
} player_localize_data_t;

typedef struct player_localize_set_pose {
  player_pose2d_t mean;
  double cov[6];
} player_localize_set_pose_t;

typedef struct player_localize_particle {
  player_pose2d_t pose;
  double alpha;
} player_localize_particle_t;

typedef struct player_localize_get_particles {
  player_pose2d_t mean;
  double variance;
  std::uint32_t particles_count;
  player_localize_particle_t* particles;
} player_localize_get_particles_t;

#define PLAYER_POSITION3D_CODE 30
#define PLAYER_POSITION3D_STRING "position3d"
#define PLAYER_POSITION3D_DATA_STATE 1
#define PLAYER_POSITION3D_DATA_GEOMETRY 2
#define PLAYER_POSITION3D_CMD_SET_VEL 1
#define PLAYER_POSITION3D_CMD_SET_POS 2
#define PLAYER_POSITION3D_REQ_GET_GEOM 1
#define PLAYER_POSITION3D_REQ_MOTOR_POWER 2
#define PLAYER_POSITION3D_REQ_VELOCITY_MODE 3
#define PLAYER_POSITION3D_REQ_POSITION_MODE 4
#define PLAYER_POSITION3D_REQ_RESET_ODOM 5
#define PLAYER_POSITION3D_REQ_SET_ODOM 6
#define PLAYER_POSITION3D_REQ_SPEED_PID 7
#define PLAYER_POSITION3D_REQ_POSITION_PID 8
#define PLAYER_POSITION3D_REQ_SPEED_PROF 9

typedef struct player_position3d_data {
  player_pose3d_t pos;
  player_pose3d_t vel;
  std::uint8_t stall;
} player_position3d_data_t;

typedef struct player_position3d_cmd_pos {
  player_pose3d_t pos;
  player_pose3d_t vel;
  std::uint8_t state;
} player_position3d_cmd_pos_t;

typedef struct player_position3d_cmd_vel {
  player_pose3d_t vel;
  std::uint8_t state;
} player_position3d_cmd_vel_t;

typedef struct player_position3d_geom {
  player_pose3d_t pose;
  player_bbox3d_t size;
} player_position3d_geom_t;

typedef struct player_position3d_power_config {
  std::uint8_t state;
} player_position3d_power_config_t;

typedef struct player_position3d_position_mode_req {
  std::uint32_t value;
} player_position3d_position_mode_req_t;

typedef struct player_position3d_velocity_mode_config {
  std::uint32_t value;
} player_position3d_velocity_mode_config_t;

typedef struct player_position3d_set_odom_req {
  player_pose3d_t pos;
} player_position3d_set_odom_req_t;

typedef struct player_position3d_speed_pid_req {
  float kp;
  float ki;
  float kd;
} player_position3d_speed_pid_req_t;

typedef struct player_position3d_position_pid_req {
  float kp;
  float ki;
  float kd;
} player_position3d_position_pid_req_t;

typedef struct player_position3d_speed_prof_req {
  float speed;
  float acc;
} player_position3d_speed_prof_req_t;

#define PLAYER_SIMULATION_CODE 31
#define PLAYER_SIMULATION_STRING "simulation"
#define PLAYER_SIMULATION_REQ_GET_POSE2D 1
#define PLAYER_SIMULATION_REQ_SET_POSE2D 2
#define PLAYER_SIMULATION_REQ_GET_POSE3D 3
#define PLAYER_SIMULATION_REQ_SET_POSE3D 4
#define PLAYER_SIMULATION_REQ_GET_PROPERTY 5
#define PLAYER_SIMULATION_REQ_SET_PROPERTY 6
#define PLAYER_SIMULATION_CMD_PAUSE 1
#define PLAYER_SIMULATION_CMD_RESET 2
#define PLAYER_SIMULATION_CMD_SAVE 3

typedef struct player_simulation_data {
  std::uint8_t data;
} player_simulation_data_t;

typedef struct player_simulation_cmd {
  std::uint8_t cmd;
} player_simulation_cmd_t;

typedef struct player_simulation_pose2d_req {
  std::uint32_t name_count;
  char* name;
  player_pose2d_t pose;
} player_simulation_pose2d_req_t;

typedef struct player_simulation_pose3d_req {
  std::uint32_t name_count;
  char* name;
  player_pose3d_t pose;
  double simtime;
} player_simulation_pose3d_req_t;

typedef struct player_simulation_property_req {
  std::uint32_t name_count;
  char* name;
  std::uint32_t prop_count;
  char* prop;
  std::uint32_t index;
  std::uint32_t value_count;
  std::uint8_t* value;
} player_simulation_property_req_t;

#define PLAYER_BLINKENLIGHT_CODE 33
#define PLAYER_BLINKENLIGHT_STRING "blinkenlight"
#define PLAYER_BLINKENLIGHT_DATA_STATE 1
#define PLAYER_BLINKENLIGHT_CMD_STATE 1
#define PLAYER_BLINKENLIGHT_CMD_POWER 2
#define PLAYER_BLINKENLIGHT_CMD_COLOR 3
#define PLAYER_BLINKENLIGHT_CMD_FLASH 4

typedef struct player_blinkenlight_data {
  std::uint8_t enable;
  float period;
  float dutycycle;
  player_color_t color;
} player_blinkenlight_data_t;

typedef struct player_blinkenlight_cmd {
  std::uint16_t id;
  std::uint8_t enable;
  float period;
  float dutycycle;
  player_color_t color;
} player_blinkenlight_cmd_t;

typedef struct player_blinkenlight_cmd_power {
  std::uint16_t id;
  std::uint8_t enable;
} player_blinkenlight_cmd_power_t;

typedef struct player_blinkenlight_cmd_color {
  std::uint16_t id;
  player_color_t color;
} player_blinkenlight_cmd_color_t;

typedef struct player_blinkenlight_cmd_flash {
  std::uint16_t id;
  float period;
  float dutycycle;
} player_blinkenlight_cmd_flash_t;

#define PLAYER_CAMERA_CODE 40
#define PLAYER_CAMERA_STRING "camera"
#define PLAYER_CAMERA_DATA_STATE 1
#define PLAYER_CAMERA_REQ_GET_SOURCE 1
#define PLAYER_CAMERA_REQ_SET_SOURCE 2
#define PLAYER_CAMERA_REQ_GET_IMAGE 3

typedef struct player_camera_data {
  std::uint32_t width;
  std::uint32_t height;
  std::uint32_t bpp;
  std::uint32_t format;
  std::uint32_t fdiv;
  std::uint32_t compression;
  std::uint32_t image_count;
  std::uint8_t* image;
} player_camera_data_t;

typedef struct player_camera_source {
  std::uint32_t norm_count;
  char* norm;
  std::int32_t source;
} player_camera_source_t;
#define PLAYER_CAMERA_FORMAT_MONO8 1
#define PLAYER_CAMERA_FORMAT_MONO16 2
#define PLAYER_CAMERA_FORMAT_RGB565 4
#define PLAYER_CAMERA_FORMAT_RGB888 5
#define PLAYER_CAMERA_COMPRESS_RAW 0
#define PLAYER_CAMERA_COMPRESS_JPEG 1

#define PLAYER_MAP_CODE 42
#define PLAYER_MAP_STRING "map"
#define PLAYER_MAP_DATA_INFO 1
#define PLAYER_MAP_REQ_GET_INFO 1
#define PLAYER_MAP_REQ_GET_DATA 2
#define PLAYER_MAP_REQ_GET_VECTOR 3

typedef struct player_map_info {
  float scale;
  std::uint32_t width;
  std::uint32_t height;
  player_pose2d_t origin;
} player_map_info_t;

typedef struct player_map_data {
  std::uint32_t col;
  std::uint32_t row;
  std::uint32_t width;
  std::uint32_t height;
  std::uint32_t data_count;
  std::int8_t data_range;
  std::uint8_t* data;
} player_map_data_t;

typedef struct player_map_data_vector {
  float minx;
  float maxx;
  float miny;
  float maxy;
  std::uint32_t segments_count;
  player_segment_t* segments;
} player_map_data_vector_t;
#define PLAYER_MAP_DATA_INFO 1

#define PLAYER_PLANNER_CODE 44
#define PLAYER_PLANNER_STRING "planner"
#define PLAYER_PLANNER_DATA_STATE 1
#define PLAYER_PLANNER_CMD_GOAL 1
#define PLAYER_PLANNER_CMD_START 2
#define PLAYER_PLANNER_REQ_GET_WAYPOINTS 1
#define PLAYER_PLANNER_REQ_ENABLE 2

typedef struct player_planner_data {
  std::uint8_t valid;
  std::uint8_t done;
  player_pose2d_t pos;
  player_pose2d_t goal;
  player_pose2d_t waypoint;
  std::int32_t waypoint_idx;
  std::uint32_t waypoints_count;
} player_planner_data_t;

typedef struct player_planner_cmd {
  player_pose2d_t goal;
} player_planner_cmd_t;

typedef struct player_planner_waypoints_req {
  double waypoints_distance;
  std::uint32_t waypoints_count;
  player_pose2d_t* waypoints;
} player_planner_waypoints_req_t;

typedef struct player_planner_enable_req {
  std::uint8_t state;
} player_planner_enable_req_t;

#define PLAYER_LOG_CODE 45
#define PLAYER_LOG_STRING "log"
#define PLAYER_LOG_REQ_SET_WRITE_STATE 1
#define PLAYER_LOG_REQ_SET_READ_STATE 2
#define PLAYER_LOG_REQ_GET_STATE 3
#define PLAYER_LOG_REQ_SET_READ_REWIND 4
#define PLAYER_LOG_REQ_SET_FILENAME 5

typedef struct player_log_set_write_state {
  std::uint8_t state;
} player_log_set_write_state_t;

typedef struct player_log_set_read_state {
  std::uint8_t state;
} player_log_set_read_state_t;

typedef struct player_log_get_state {
  std::uint8_t type;
  std::uint8_t state;
} player_log_get_state_t;

typedef struct player_log_set_filename {
  std::uint32_t filename_count;
  char filename[256];
} player_log_set_filename_t;
#define PLAYER_LOG_TYPE_READ 1
#define PLAYER_LOG_TYPE_WRITE 2

#define PLAYER_JOYSTICK_CODE 49
#define PLAYER_JOYSTICK_STRING "joystick"
#define PLAYER_JOYSTICK_DATA_STATE 1

typedef struct player_joystick_data {
  std::int32_t pos[8];
  std::int32_t scale[8];
  std::uint32_t buttons;
  std::uint32_t axes_count;
} player_joystick_data_t;

#define PLAYER_SPEECH_RECOGNITION_CODE 50
#define PLAYER_SPEECH_RECOGNITION_STRING "speech_recognition"
#define PLAYER_SPEECH_RECOGNITION_DATA_STRING 1

typedef struct player_speech_recognition_data {
  std::uint32_t text_count;
  char* text;
} player_speech_recognition_data_t;

#define PLAYER_OPAQUE_CODE 51
#define PLAYER_OPAQUE_STRING "opaque"
#define PLAYER_OPAQUE_DATA_STATE 1
#define PLAYER_OPAQUE_CMD_DATA 1
#define PLAYER_OPAQUE_REQ_DATA 1

typedef struct player_opaque_data {
  std::uint32_t data_count;
  std::uint8_t* data;
} player_opaque_data_t;

#define PLAYER_POSITION1D_CODE 52
#define PLAYER_POSITION1D_STRING "position1d"
#define PLAYER_POSITION1D_REQ_GET_GEOM 1
#define PLAYER_POSITION1D_REQ_MOTOR_POWER 2
#define PLAYER_POSITION1D_REQ_VELOCITY_MODE 3
#define PLAYER_POSITION1D_REQ_POSITION_MODE 4
#define PLAYER_POSITION1D_REQ_SET_ODOM 5
#define PLAYER_POSITION1D_REQ_RESET_ODOM 6
#define PLAYER_POSITION1D_REQ_SPEED_PID 7
#define PLAYER_POSITION1D_REQ_POSITION_PID 8
#define PLAYER_POSITION1D_REQ_SPEED_PROF 9
#define PLAYER_POSITION1D_DATA_STATE 1
#define PLAYER_POSITION1D_DATA_GEOM 2
#define PLAYER_POSITION1D_CMD_VEL 1
#define PLAYER_POSITION1D_CMD_POS 2

typedef struct player_position1d_data {
  float pos;
  float vel;
  std::uint8_t stall;
  std::uint8_t status;
} player_position1d_data_t;

typedef struct player_position1d_cmd_vel {
  float vel;
  std::uint8_t state;
} player_position1d_cmd_vel_t;

typedef struct player_position1d_cmd_pos {
  float pos;
  float vel;
  std::uint8_t state;
} player_position1d_cmd_pos_t;

typedef struct player_position1d_geom {
  player_pose3d_t pose;
  player_bbox3d_t size;
} player_position1d_geom_t;

typedef struct player_position1d_power_config {
  std::uint8_t state;
} player_position1d_power_config_t;

typedef struct player_position1d_velocity_mode_config {
  std::uint32_t value;
} player_position1d_velocity_mode_config_t;

typedef struct player_position1d_reset_odom_config {
  std::uint32_t value;
} player_position1d_reset_odom_config_t;

typedef struct player_position1d_position_mode_req {
  std::uint32_t state;
} player_position1d_position_mode_req_t;

typedef struct player_position1d_set_odom_req {
  float pos;
} player_position1d_set_odom_req_t;

typedef struct player_position1d_speed_pid_req {
  float kp;
  float ki;
  float kd;
} player_position1d_speed_pid_req_t;

typedef struct player_position1d_position_pid_req {
  float kp;
  float ki;
  float kd;
} player_position1d_position_pid_req_t;

typedef struct player_position1d_speed_prof_req {
  float speed;
  float acc;
} player_position1d_speed_prof_req_t;
#define PLAYER_POSITION1D_STATUS_LIMIT_MIN 0
#define PLAYER_POSITION1D_STATUS_LIMIT_CEN 1
#define PLAYER_POSITION1D_STATUS_LIMIT_MAX 2
#define PLAYER_POSITION1D_STATUS_OC 3
#define PLAYER_POSITION1D_STATUS_TRAJ_COMPLETE 4
#define PLAYER_POSITION1D_STATUS_ENABLED 5

#define PLAYER_ACTARRAY_CODE 53
#define PLAYER_ACTARRAY_STRING "actarray"
#define PLAYER_ACTARRAY_REQ_POWER 1
#define PLAYER_ACTARRAY_REQ_BRAKES 2
#define PLAYER_ACTARRAY_REQ_GET_GEOM 3
#define PLAYER_ACTARRAY_REQ_SPEED 4
#define PLAYER_ACTARRAY_REQ_ACCEL 5
#define PLAYER_ACTARRAY_CMD_POS 1
#define PLAYER_ACTARRAY_CMD_MULTI_POS 2
#define PLAYER_ACTARRAY_CMD_SPEED 3
#define PLAYER_ACTARRAY_CMD_MULTI_SPEED 4
#define PLAYER_ACTARRAY_CMD_HOME 5
#define PLAYER_ACTARRAY_CMD_CURRENT 6
#define PLAYER_ACTARRAY_CMD_MULTI_CURRENT 7
#define PLAYER_ACTARRAY_DATA_STATE 1

typedef struct player_actarray_actuator {
  float position;
  float speed;
  float acceleration;
  float current;
  std::uint8_t state;
} player_actarray_actuator_t;

typedef struct player_actarray_data {
  std::uint32_t actuators_count;
  player_actarray_actuator_t* actuators;
  std::uint8_t motor_state;
} player_actarray_data_t;

typedef struct player_actarray_actuatorgeom {
  std::uint8_t type;
  float length;
  player_orientation_3d_t orientation;
  player_point_3d_t axis;
  float min;
  float centre;
  float max;
  float home;
  float config_speed;
  std::uint8_t hasbrakes;
} player_actarray_actuatorgeom_t;

typedef struct player_actarray_geom {
  std::uint32_t actuators_count;
  player_actarray_actuatorgeom_t* actuators;
  player_point_3d_t base_pos;
  player_orientation_3d_t base_orientation;
} player_actarray_geom_t;

typedef struct player_actarray_position_cmd {
  std::int32_t joint;
  float position;
} player_actarray_position_cmd_t;

typedef struct player_actarray_multi_position_cmd {
  std::uint32_t positions_count;
  float* positions;
} player_actarray_multi_position_cmd_t;

typedef struct player_actarray_speed_cmd {
  std::int32_t joint;
  float speed;
} player_actarray_speed_cmd_t;

typedef struct player_actarray_multi_speed_cmd {
  std::uint32_t speeds_count;
  float* speeds;
} player_actarray_multi_speed_cmd_t;

typedef struct player_actarray_home_cmd {
  std::int32_t joint;
} player_actarray_home_cmd_t;

typedef struct player_actarray_current_cmd {
  std::int32_t joint;
  float current;
} player_actarray_current_cmd_t;

typedef struct player_actarray_multi_current_cmd {
  std::uint32_t currents_count;
  float* currents;
} player_actarray_multi_current_cmd_t;

typedef struct player_actarray_power_config {
  std::uint8_t value;
} player_actarray_power_config_t;

typedef struct player_actarray_brakes_config {
  std::uint8_t value;
} player_actarray_brakes_config_t;

typedef struct player_actarray_speed_config {
  std::int32_t joint;
  float speed;
} player_actarray_speed_config_t;

typedef struct player_actarray_accel_config {
  std::int32_t joint;
  float accel;
} player_actarray_accel_config_t;
#define PLAYER_ACTARRAY_ACTSTATE_IDLE 1
#define PLAYER_ACTARRAY_ACTSTATE_MOVING 2
#define PLAYER_ACTARRAY_ACTSTATE_BRAKED 4
#define PLAYER_ACTARRAY_ACTSTATE_STALLED 8
#define PLAYER_ACTARRAY_TYPE_LINEAR 1
#define PLAYER_ACTARRAY_TYPE_ROTARY 2

#define PLAYER_LIMB_CODE 54
#define PLAYER_LIMB_STRING "limb"
#define PLAYER_LIMB_DATA_STATE 1
#define PLAYER_LIMB_CMD_HOME 1
#define PLAYER_LIMB_CMD_STOP 2
#define PLAYER_LIMB_CMD_SETPOSE 3
#define PLAYER_LIMB_CMD_SETPOSITION 4
#define PLAYER_LIMB_CMD_VECMOVE 5
#define PLAYER_LIMB_REQ_POWER 1
#define PLAYER_LIMB_REQ_BRAKES 2
#define PLAYER_LIMB_REQ_GEOM 3
#define PLAYER_LIMB_REQ_SPEED 4

typedef struct player_limb_data {
  player_point_3d_t position;
  player_point_3d_t approach;
  player_point_3d_t orientation;
  std::uint8_t state;
} player_limb_data_t;

typedef struct player_limb_setpose_cmd {
  player_point_3d_t position;
  player_point_3d_t approach;
  player_point_3d_t orientation;
} player_limb_setpose_cmd_t;

typedef struct player_limb_setposition_cmd {
  player_point_3d_t position;
} player_limb_setposition_cmd_t;

typedef struct player_limb_vecmove_cmd {
  player_point_3d_t direction;
  float length;
} player_limb_vecmove_cmd_t;

typedef struct player_limb_power_req {
  std::uint8_t value;
} player_limb_power_req_t;

typedef struct player_limb_brakes_req {
  std::uint8_t value;
} player_limb_brakes_req_t;

typedef struct player_limb_geom_req {
  player_point_3d_t basePos;
} player_limb_geom_req_t;

typedef struct player_limb_speed_req {
  float speed;
} player_limb_speed_req_t;
#define PLAYER_LIMB_STATE_IDLE 1
#define PLAYER_LIMB_STATE_BRAKED 2
#define PLAYER_LIMB_STATE_MOVING 3
#define PLAYER_LIMB_STATE_OOR 4
#define PLAYER_LIMB_STATE_COLL 5

#define PLAYER_GRAPHICS2D_CODE 55
#define PLAYER_GRAPHICS2D_STRING "graphics2d"
#define PLAYER_GRAPHICS2D_CMD_CLEAR 1
#define PLAYER_GRAPHICS2D_CMD_POINTS 2
#define PLAYER_GRAPHICS2D_CMD_POLYLINE 3
#define PLAYER_GRAPHICS2D_CMD_POLYGON 4
#define PLAYER_GRAPHICS2D_CMD_MULTILINE 5

typedef struct player_graphics2d_cmd_points {
  std::uint32_t points_count;
  player_point_2d_t* points;
  player_color_t color;
} player_graphics2d_cmd_points_t;

typedef struct player_graphics2d_cmd_polyline {
  std::uint32_t points_count;
  player_point_2d_t* points;
  player_color_t color;
} player_graphics2d_cmd_polyline_t;

typedef struct player_graphics2d_cmd_polygon {
  std::uint32_t points_count;
  player_point_2d_t* points;
  player_color_t color;
  player_color_t fill_color;
  std::uint8_t filled;
} player_graphics2d_cmd_polygon_t;

typedef struct player_graphics2d_cmd_multiline {
  std::uint32_t points_count;
  player_point_2d_t* points;
  player_color_t color;
} player_graphics2d_cmd_multiline_t;

#define PLAYER_RFID_CODE 56
#define PLAYER_RFID_STRING "rfid"
#define PLAYER_RFID_DATA_TAGS 1
#define PLAYER_RFID_REQ_POWER 1
#define PLAYER_RFID_REQ_READTAG 2
#define PLAYER_RFID_REQ_WRITETAG 3
#define PLAYER_RFID_REQ_LOCKTAG 4

typedef struct player_rfid_tag {
  std::uint32_t type;
  std::uint32_t guid_count;
  std::uint8_t* guid;
} player_rfid_tag_t;

typedef struct player_rfid_data {
  std::uint32_t tags_count;
  player_rfid_tag_t* tags;
} player_rfid_data_t;

#define PLAYER_WSN_CODE 57
#define PLAYER_WSN_STRING "wsn"
#define PLAYER_WSN_DATA_STATE 1
#define PLAYER_WSN_CMD_DEVSTATE 1
#define PLAYER_WSN_REQ_POWER 1
#define PLAYER_WSN_REQ_DATATYPE 2
#define PLAYER_WSN_REQ_DATAFREQ 3

typedef struct player_wsn_node_data {
  float light;
  float mic;
  float accel_x;
  float accel_y;
  float accel_z;
  float magn_x;
  float magn_y;
  float magn_z;
  float temperature;
  float battery;
} player_wsn_node_data_t;

typedef struct player_wsn_data {
  std::uint32_t node_type;
  std::uint32_t node_id;
  std::uint32_t node_parent_id;
  player_wsn_node_data_t data_packet;
} player_wsn_data_t;

typedef struct player_wsn_cmd {
  std::int32_t node_id;
  std::int32_t group_id;
  std::uint32_t device;
  std::uint8_t enable;
} player_wsn_cmd_t;

typedef struct player_wsn_power_config {
  std::int32_t node_id;
  std::int32_t group_id;
  std::uint8_t value;
} player_wsn_power_config_t;

typedef struct player_wsn_datatype_config {
  std::uint8_t value;
} player_wsn_datatype_config_t;

typedef struct player_wsn_datafreq_config {
  std::int32_t node_id;
  std::int32_t group_id;
  double frequency;
} player_wsn_datafreq_config_t;

#define PLAYER_GRAPHICS3D_CODE 58
#define PLAYER_GRAPHICS3D_STRING "graphics3d"
#define PLAYER_GRAPHICS3D_CMD_CLEAR 1
#define PLAYER_GRAPHICS3D_CMD_DRAW 2
#define PLAYER_GRAPHICS3D_CMD_TRANSLATE 3
#define PLAYER_GRAPHICS3D_CMD_ROTATE 4
#define PLAYER_GRAPHICS3D_CMD_PUSH 5
#define PLAYER_GRAPHICS3D_CMD_POP 6

typedef struct player_graphics3d_cmd_draw {
  std::uint32_t draw_mode;
  std::uint32_t points_count;
  player_point_3d_t* points;
  player_color_t color;
} player_graphics3d_cmd_draw_t;

typedef struct player_graphics3d_cmd_translate {
  double x;
  double y;
  double z;
} player_graphics3d_cmd_translate_t;

typedef struct player_graphics3d_cmd_rotate {
  double a;
  double x;
  double y;
  double z;
} player_graphics3d_cmd_rotate_t;

typedef enum player_graphics3d_draw_mode {
  PLAYER_DRAW_POINTS,
  PLAYER_DRAW_LINES,
  PLAYER_DRAW_LINE_STRIP,
  PLAYER_DRAW_LINE_LOOP,
  PLAYER_DRAW_TRIANGLES,
  PLAYER_DRAW_TRIANGLE_STRIP,
  PLAYER_DRAW_TRIANGLE_FAN,
  PLAYER_DRAW_QUADS,
  PLAYER_DRAW_QUAD_STRIP,
  PLAYER_DRAW_POLYGON
} player_graphics3d_draw_mode_t;

#define PLAYER_HEALTH_CODE 59
#define PLAYER_HEALTH_STRING "health"
#define PLAYER_HEALTH_DATA_STATE 1

typedef struct player_health_cpu {
  float idle;
  float system;
  float user;
} player_health_cpu_t;

typedef struct player_health_memory {
  std::int64_t total;
  std::int64_t used;
  std::int64_t free;
} player_health_memory_t;

typedef struct player_health_data {
  player_health_cpu_t cpu_usage;
  player_health_memory_t mem;
  player_health_memory_t swap;
} player_health_data_t;

#define PLAYER_IMU_CODE 60
#define PLAYER_IMU_STRING "imu"
#define PLAYER_IMU_DATA_STATE 1
#define PLAYER_IMU_DATA_CALIB 2
#define PLAYER_IMU_DATA_QUAT 3
#define PLAYER_IMU_DATA_EULER 4
#define PLAYER_IMU_DATA_FULLSTATE 5
#define PLAYER_IMU_REQ_SET_DATATYPE 1
#define PLAYER_IMU_REQ_RESET_ORIENTATION 2
#define PLAYER_IMU_REQ_RESET_EULER 3

typedef struct player_imu_data_state {
  player_pose3d_t pose;
} player_imu_data_state_t;

typedef struct player_imu_data_calib {
  float accel_x;
  float accel_y;
  float accel_z;
  float gyro_x;
  float gyro_y;
  float gyro_z;
  float magn_x;
  float magn_y;
  float magn_z;
} player_imu_data_calib_t;

typedef struct player_imu_data_quat {
  player_imu_data_calib_t calib_data;
  float q0;
  float q1;
  float q2;
  float q3;
} player_imu_data_quat_t;

typedef struct player_imu_data_euler {
  player_imu_data_calib_t calib_data;
  player_orientation_3d_t orientation;
} player_imu_data_euler_t;

typedef struct player_imu_data_fullstate {
  player_pose3d_t pose;
  player_pose3d_t vel;
  player_pose3d_t acc;
} player_imu_data_fullstate_t;

typedef struct player_imu_datatype_config {
  std::uint8_t value;
} player_imu_datatype_config_t;

typedef struct player_imu_reset_orientation_config {
  std::uint32_t value;
} player_imu_reset_orientation_config_t;

typedef struct player_imu_reset_euler_config {
  player_pose3d_t orientation;
} player_imu_reset_euler_config_t;

#define PLAYER_POINTCLOUD3D_CODE 61
#define PLAYER_POINTCLOUD3D_STRING "pointcloud3d"
#define PLAYER_POINTCLOUD3D_DATA_STATE 1

typedef struct player_pointcloud3d_element {
  player_point_3d_t point;
  player_color_t color;
} player_pointcloud3d_element_t;

typedef struct player_pointcloud3d_data {
  std::uint32_t points_count;
  player_pointcloud3d_element_t* points;
} player_pointcloud3d_data_t;

#define PLAYER_RANGER_CODE 62
#define PLAYER_RANGER_STRING "ranger"
#define PLAYER_RANGER_DATA_RANGE 1
#define PLAYER_RANGER_DATA_RANGESTAMPED 2
#define PLAYER_RANGER_DATA_INTNS 3
#define PLAYER_RANGER_DATA_INTNSSTAMPED 4
#define PLAYER_RANGER_DATA_GEOM 5
#define PLAYER_RANGER_REQ_GET_GEOM 1
#define PLAYER_RANGER_REQ_POWER 2
#define PLAYER_RANGER_REQ_INTNS 3
#define PLAYER_RANGER_REQ_SET_CONFIG 4
#define PLAYER_RANGER_REQ_GET_CONFIG 5

typedef struct player_ranger_config {
  double min_angle;
  double max_angle;
  double angular_res;
  double min_range;
  double max_range;
  double range_res;
  double frequency;
} player_ranger_config_t;

typedef struct player_ranger_geom {
  player_pose3d_t pose;
  player_bbox3d_t size;
  std::uint32_t element_poses_count;
  player_pose3d_t* element_poses;
  std::uint32_t element_sizes_count;
  player_bbox3d_t* element_sizes;
} player_ranger_geom_t;

typedef struct player_ranger_data_range {
  std::uint32_t ranges_count;
  double* ranges;
} player_ranger_data_range_t;

typedef struct player_ranger_data_rangestamped {
  player_ranger_data_range_t data;
  std::uint8_t have_geom;
  player_ranger_geom_t geom;
  std::uint8_t have_config;
  player_ranger_config_t config;
} player_ranger_data_rangestamped_t;

typedef struct player_ranger_data_intns {
  std::uint32_t intensities_count;
  double* intensities;
} player_ranger_data_intns_t;

typedef struct player_ranger_data_intnsstamped {
  player_ranger_data_intns_t data;
  std::uint8_t have_geom;
  player_ranger_geom_t geom;
  std::uint8_t have_config;
  player_ranger_config_t config;
} player_ranger_data_intnsstamped_t;

typedef struct player_ranger_power_config {
  std::uint8_t state;
} player_ranger_power_config_t;

typedef struct player_ranger_intns_config {
  std::uint8_t state;
} player_ranger_intns_config_t;

#define PLAYER_VECTORMAP_CODE 63
#define PLAYER_VECTORMAP_STRING "vectormap"
#define PLAYER_VECTORMAP_REQ_GET_MAP_INFO 1
#define PLAYER_VECTORMAP_REQ_GET_LAYER_DATA 3
#define PLAYER_VECTORMAP_REQ_WRITE_LAYER 4

typedef struct player_vectormap_feature_data {
  std::uint32_t name_count;
  char* name;
  std::uint32_t wkb_count;
  std::uint8_t* wkb;
  std::uint32_t attrib_count;
  char* attrib;
} player_vectormap_feature_data_t;

typedef struct player_vectormap_layer_info {
  std::uint32_t name_count;
  char* name;
  player_extent2d_t extent;
} player_vectormap_layer_info_t;

typedef struct player_vectormap_layer_data {
  std::uint32_t name_count;
  char* name;
  std::uint32_t features_count;
  player_vectormap_feature_data_t* features;
} player_vectormap_layer_data_t;

typedef struct player_vectormap_info {
  std::uint32_t srid;
  std::uint32_t layers_count;
  player_vectormap_layer_info_t* layers;
  player_extent2d_t extent;
} player_vectormap_info_t;

#define PLAYER_BLACKBOARD_CODE 64
#define PLAYER_BLACKBOARD_STRING "blackboard"
#define PLAYER_BLACKBOARD_REQ_SUBSCRIBE_TO_KEY 1
#define PLAYER_BLACKBOARD_REQ_UNSUBSCRIBE_FROM_KEY 2
#define PLAYER_BLACKBOARD_REQ_SET_ENTRY 3
#define PLAYER_BLACKBOARD_REQ_SUBSCRIBE_TO_GROUP 4
#define PLAYER_BLACKBOARD_REQ_UNSUBSCRIBE_FROM_GROUP 5
#define PLAYER_BLACKBOARD_REQ_GET_ENTRY 6
#define PLAYER_BLACKBOARD_DATA_UPDATE 1

typedef struct player_blackboard_entry {
  std::uint16_t type;
  std::uint16_t subtype;
  std::uint32_t key_count;
  char* key;
  std::uint32_t group_count;
  char* group;
  std::uint32_t data_count;
  std::uint8_t* data;
  std::uint32_t timestamp_sec;
  std::uint32_t timestamp_usec;
} player_blackboard_entry_t;

#define PLAYER_STEREO_CODE 65
#define PLAYER_STEREO_STRING "stereo"
#define PLAYER_STEREO_DATA_STATE 1

typedef struct player_pointcloud3d_stereo_element {
  float px;
  float py;
  float pz;
  std::uint8_t red;
  std::uint8_t green;
  std::uint8_t blue;
} player_pointcloud3d_stereo_element_t;

typedef struct player_stereo_data {
  player_camera_data_t left_channel;
  player_camera_data_t right_channel;
  player_camera_data_t disparity;
  std::uint32_t points_count;
  player_pointcloud3d_stereo_element_t* points;
  std::uint32_t mode;
} player_stereo_data_t;

#define PLAYER_COOPOBJECT_CODE 66
#define PLAYER_COOPOBJECT_STRING "coopobject"
#define PLAYER_COOPOBJECT_DATA_HEALTH 1
#define PLAYER_COOPOBJECT_DATA_RSSI 2
#define PLAYER_COOPOBJECT_DATA_SENSOR 3
#define PLAYER_COOPOBJECT_DATA_ALARM 4
#define PLAYER_COOPOBJECT_DATA_USERDEFINED 5
#define PLAYER_COOPOBJECT_DATA_REQUEST 6
#define PLAYER_COOPOBJECT_DATA_COMMAND 7
#define PLAYER_COOPOBJECT_DATA_POSITION 8
#define PLAYER_COOPOBJECT_CMD_STANDARD 1
#define PLAYER_COOPOBJECT_CMD_DATA 2
#define PLAYER_COOPOBJECT_CMD_POSITION 3
#define PLAYER_COOPOBJECT_REQ_STANDARD 1

typedef struct player_coopobject_header {
  std::uint8_t origin;
  std::uint16_t id;
  std::uint16_t parent_id;
} player_coopobject_header_t;

typedef struct player_coopobject_rssi {
  player_coopobject_header_t header;
  std::uint16_t sender_id;
  std::uint16_t rssi;
  std::uint16_t stamp;
  std::uint32_t nodeTimeHigh;
  std::uint32_t nodeTimeLow;
  float x;
  float y;
  float z;
} player_coopobject_rssi_t;

typedef struct player_coopobject_position {
  player_coopobject_header_t header;
  float x;
  float y;
  float z;
  std::uint8_t status;
} player_coopobject_position_t;

typedef struct player_coopobject_sensor {
  std::uint8_t type;
  std::int16_t value;
} player_coopobject_sensor_t;

typedef struct player_coopobject_data_sensor {
  player_coopobject_header_t header;
  std::uint32_t data_count;
  player_coopobject_sensor_t* data;
} player_coopobject_data_sensor_t;

typedef struct player_coopobject_data_userdefined {
  player_coopobject_header_t header;
  std::uint8_t type;
  std::uint32_t data_count;
  std::uint8_t* data;
} player_coopobject_data_userdefined_t;

typedef struct player_coopobject_req {
  player_coopobject_header_t header;
  std::uint8_t request;
  std::uint32_t parameters_count;
  std::uint8_t* parameters;
} player_coopobject_req_t;

typedef struct player_coopobject_cmd {
  player_coopobject_header_t header;
  std::uint8_t command;
  std::uint32_t parameters_count;
  std::uint8_t* parameters;
} player_coopobject_cmd_t;
#define PLAYER_COOPOBJECT_ORIGIN_STATICBASE 0
#define PLAYER_COOPOBJECT_ORIGIN_MOBILEBASE 1
#define PLAYER_COOPOBJECT_ORIGIN_MOTE 2
#define PLAYER_COOPOBJECT_ORIGIN_ROBOT 3
#define PLAYER_COOPOBJECT_MSG_NONE -1
#define PLAYER_COOPOBJECT_MSG_HEALTH 0
#define PLAYER_COOPOBJECT_MSG_POSITION 1
#define PLAYER_COOPOBJECT_MSG_RSSI 2
#define PLAYER_COOPOBJECT_MSG_SENSOR 3
#define PLAYER_COOPOBJECT_MSG_ALARM 4
#define PLAYER_COOPOBJECT_MSG_REQUEST 5
#define PLAYER_COOPOBJECT_MSG_COMMAND 6
#define PLAYER_COOPOBJECT_TEMPERATURE 0
#define PLAYER_COOPOBJECT_HUMIDITY 1
#define PLAYER_COOPOBJECT_PRESSURE 2
#define PLAYER_COOPOBJECT_LIGHT_1 3
#define PLAYER_COOPOBJECT_LIGHT_2 4
#define PLAYER_COOPOBJECT_ACCEL_X 5
#define PLAYER_COOPOBJECT_ACCEL_Y 6
#define PLAYER_COOPOBJECT_ACCEL_Z 7
#define PLAYER_COOPOBJECT_MAGNETOMETER_X 8
#define PLAYER_COOPOBJECT_MAGNETOMETER_Y 9
#define PLAYER_COOPOBJECT_MAGNETOMETER_Z 10
#define PLAYER_COOPOBJECT_COMPASS 11
#define PLAYER_COOPOBJECT_CO 12
#define PLAYER_COOPOBJECT_CO2 13
#define PLAYER_COOPOBJECT_H2 14
#define PLAYER_COOPOBJECT_SMOKE 15
#define PLAYER_COOPOBJECT_OPTSWITCH 16

// NOLINTEND(modernize-use-using,cppcoreguidelines-macro-usage,modernize-macro-to-enum)
